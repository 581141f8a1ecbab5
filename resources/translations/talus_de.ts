<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source> of %1</source>
        <translation> von %1</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>%1 is used by %2</source>
        <translation>%1 wird benutzt von %2</translation>
    </message>
    <message>
        <source>let them use another one first</source>
        <translation>diese zuerst etwas anderes benutzen lassen</translation>
    </message>
    <message>
        <source>add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>duplicate %1</source>
        <translation>%1 verdoppeln</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>the results hold until then</source>
        <translation>bis dahin gelten die Ergebnisse</translation>
    </message>
    <message>
        <source>%1 was expected at %2 s, within %3</source>
        <translation>%1 wurde bei %2 s erwartet, auf %3 genau</translation>
    </message>
    <message>
        <source>is %1; %2</source>
        <translation>ist %1; %2</translation>
    </message>
    <message>
        <source>was not reached by the run; %1</source>
        <translation>wurde vom Lauf nicht erreicht; %1</translation>
    </message>
    <message>
        <source>see how it went in the histories, and which of project and expectation is wrong</source>
        <translation>in den Verläufen nachsehen, was geschah und ob Projekt oder Erwartung falsch ist</translation>
    </message>
    <message>
        <source>stopped at %1 s</source>
        <translation>bei %1 s angehalten</translation>
    </message>
    <message>
        <source>did not converge at %1 s</source>
        <translation>bei %1 s nicht konvergiert</translation>
    </message>
    <message>
        <source>%1 of %2 expected values missed</source>
        <translation>%1 von %2 erwarteten Werten verfehlt</translation>
    </message>
    <message>
        <source>save the project in another folder, where its results will lie beside it</source>
        <translation>das Projekt in einem anderen Ordner sichern; seine Ergebnisse liegen dann daneben</translation>
    </message>
    <message>
        <source>a run goes on</source>
        <translation>ein Lauf ist im Gange</translation>
    </message>
    <message>
        <source>stop it before opening another file</source>
        <translation>ihn anhalten, bevor eine andere Datei geöffnet wird</translation>
    </message>
    <message>
        <source>began %1</source>
        <translation>%1 begonnen</translation>
    </message>
    <message>
        <source>opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>open a project file, or a folder that a run has written</source>
        <translation>eine Projektdatei öffnen oder einen Ordner, den ein Lauf geschrieben hat</translation>
    </message>
    <message>
        <source>opened results in %1</source>
        <translation>Ergebnisse in %1 geöffnet</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>Shown in %1; any unit of its kind can be typed.</source>
        <translation>Gezeigt in %1; jede Einheit dieser Art kann eingegeben werden.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 (usual)</source>
        <translation>%1 (üblich)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>affin</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>polyhedron, %1 faces</source>
        <translation>Polyeder, %1 Flächen</translation>
    </message>
    <message>
        <source>terrain, %1</source>
        <translation>Gelände, %1</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>section, %1 corners</source>
        <translation>Profil, %1 Ecken</translation>
    </message>
    <message>
        <source> less </source>
        <translation> ohne </translation>
    </message>
    <message>
        <source>common to %1</source>
        <translation>gemeinsam in %1</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>static</source>
        <translation>statisch</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamisch</translation>
    </message>
    <message>
        <source>%1, %2 … %3 s</source>
        <translation>%1, %2 … %3 s</translation>
    </message>
    <message>
        <source>φ %1°</source>
        <translation>φ %1°</translation>
    </message>
    <message>
        <source>residual φ %1°</source>
        <translation>Rest-φ %1°</translation>
    </message>
    <message>
        <source>c %1 MPa</source>
        <translation>c %1 MPa</translation>
    </message>
    <message>
        <source>tension %1 MPa</source>
        <translation>Zugfestigkeit %1 MPa</translation>
    </message>
    <message>
        <source>no %1</source>
        <translation>keine %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>held</source>
        <translation>festgehalten</translation>
    </message>
    <message>
        <source>let go</source>
        <translation>losgelassen</translation>
    </message>
    <message>
        <source>damping %1 1/s</source>
        <translation>Dämpfung %1 1/s</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>; densest %1</source>
        <translation>; am dichtesten %1</translation>
    </message>
    <message>
        <source>Motion of blocks</source>
        <translation>Bewegung der Blöcke</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Trend/plunge</source>
        <translation>Richtung/Neigung</translation>
    </message>
    <message>
        <source>Moved m</source>
        <translation>Weg m</translation>
    </message>
    <message>
        <source>All blocks are fixed.</source>
        <translation>Alle Blöcke sind fest.</translation>
    </message>
    <message>
        <source>%1, to %2</source>
        <translation>%1, nach %2</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>Mesh size m</source>
        <translation>Netzweite m</translation>
    </message>
    <message>
        <source>The project has no solid.</source>
        <translation>Das Projekt hat keinen Körper.</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>selbsttätig</translation>
    </message>
    <message>
        <source>Joint table</source>
        <translation>Klufttabelle</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Kluft</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Dip °</source>
        <translation>Fallen °</translation>
    </message>
    <message>
        <source>Dir °</source>
        <translation>Richtung °</translation>
    </message>
    <message>
        <source>Spacing m</source>
        <translation>Abstand m</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>φ °</source>
        <translation>φ °</translation>
    </message>
    <message>
        <source>c MPa</source>
        <translation>c MPa</translation>
    </message>
    <message>
        <source>The project has no joint: its solids touch without being cut.</source>
        <translation>Das Projekt hat keine Kluft: seine Körper berühren sich ungeschnitten.</translation>
    </message>
    <message>
        <source>Volume m³</source>
        <translation>Volumen m³</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Werkstoffe</translation>
    </message>
    <message>
        <source>ρ kg/m³</source>
        <translation>ρ kg/m³</translation>
    </message>
    <message>
        <source>E GPa</source>
        <translation>E GPa</translation>
    </message>
    <message>
        <source>ν</source>
        <translation>ν</translation>
    </message>
    <message>
        <source>Damping 1/s</source>
        <translation>Dämpfung 1/s</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>Gesetz</translation>
    </message>
    <message>
        <source>The project has no material.</source>
        <translation>Das Projekt hat keinen Werkstoff.</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>At m</source>
        <translation>Ort m</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Nothing but gravity acts.</source>
        <translation>Nur die Schwerkraft wirkt.</translation>
    </message>
    <message>
        <source>force, kN</source>
        <translation>Kraft, kN</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>support, m</source>
        <translation>Lager, m</translation>
    </message>
    <message>
        <source>whole block</source>
        <translation>ganzer Block</translation>
    </message>
    <message>
        <source>velocity, m/s</source>
        <translation>Geschwindigkeit, m/s</translation>
    </message>
    <message>
        <source>stress in situ, MPa</source>
        <translation>Primärspannung, MPa</translation>
    </message>
    <message>
        <source>every block</source>
        <translation>alle Blöcke</translation>
    </message>
    <message>
        <source>z %1</source>
        <translation>z %1</translation>
    </message>
    <message>
        <source>monitor %1</source>
        <translation>Messpunkt %1</translation>
    </message>
    <message>
        <source>motion and stress</source>
        <translation>Bewegung und Spannung</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Δt ms</source>
        <translation>Δt ms</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Duration s</source>
        <translation>Dauer s</translation>
    </message>
    <message>
        <source>The project has no stage: there is nothing to solve.</source>
        <translation>Das Projekt hat keinen Abschnitt: es gibt nichts zu rechnen.</translation>
    </message>
    <message>
        <source>static, until equilibrium</source>
        <translation>statisch, bis zum Gleichgewicht</translation>
    </message>
    <message>
        <source>Show in view</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Turns the view to the place and selects its blocks</source>
        <translation>Dreht die Ansicht zu der Stelle und wählt ihre Blöcke</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>static %1</source>
        <translation>statisch %1</translation>
    </message>
    <message>
        <source>less than 1 MB</source>
        <translation>weniger als 1 MB</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation>%1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>cutting and meshing</source>
        <translation>schneidet und vernetzt</translation>
    </message>
    <message>
        <source>running</source>
        <translation>rechnet</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>hält inne</translation>
    </message>
    <message>
        <source>stopping after this step</source>
        <translation>hält nach diesem Schritt an</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>no place can be told</source>
        <translation>kein Ort bekannt</translation>
    </message>
    <message>
        <source>%1, joint %2</source>
        <translation>%1, Kluft %2</translation>
    </message>
    <message>
        <source>hardest at t = %1 s</source>
        <translation>am schwersten bei t = %1 s</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>mesh size</source>
        <translation>Netzweite</translation>
    </message>
    <message>
        <source>time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>static step</source>
        <translation>statischer Schritt</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>%1 at scale %2</source>
        <translation>%1 im Maßstab %2</translation>
    </message>
    <message>
        <source>%1: failed, %2</source>
        <translation>%1: gescheitert, %2</translation>
    </message>
    <message>
        <source>%1: the same bits</source>
        <translation>%1: bitgleich</translation>
    </message>
    <message>
        <source>%1: relative difference %2</source>
        <translation>%1: relativer Unterschied %2</translation>
    </message>
    <message>
        <source>; about zero %1 of the tolerance (%2)</source>
        <translation>; um null %1 der Toleranz (%2)</translation>
    </message>
    <message>
        <source>Hard cases, chosen to break contact codes</source>
        <translation>Schwere Fälle, gewählt, um Kontaktprogramme zu brechen</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Must come to</source>
        <translation>Muss ergeben</translation>
    </message>
    <message>
        <source>Ending</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Penetration</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Zuwachs</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Kürzungen</translation>
    </message>
    <message>
        <source>Cases are being run</source>
        <translation>Fälle werden gerechnet</translation>
    </message>
    <message>
        <source>No case has been run yet</source>
        <translation>Noch ist kein Fall gerechnet</translation>
    </message>
    <message>
        <source>%1 of %2 hold</source>
        <translation>%1 von %2 halten</translation>
    </message>
    <message>
        <source>Also again, on one and two threads</source>
        <translation>Auch noch einmal, auf einem und zwei Threads</translation>
    </message>
    <message>
        <source>Each case is run twice more: on one thread and on two it must give the same bits</source>
        <translation>Jeder Fall läuft zweimal mehr: auf einem Thread und auf zweien muss er dieselben Bits ergeben</translation>
    </message>
    <message>
        <source>Cases with a known answer</source>
        <translation>Fälle mit bekannter Antwort</translation>
    </message>
    <message>
        <source>%1 of %2 passed</source>
        <translation>%1 von %2 bestanden</translation>
    </message>
    <message>
        <source>Also on two threads and at 1/10 scale</source>
        <translation>Auch auf zwei Threads und im Maßstab 1/10</translation>
    </message>
    <message>
        <source>Each case is run twice more: on two threads it must give the same bits, at a tenth of the scale the same relative numbers</source>
        <translation>Jeder Fall läuft zweimal mehr: auf zwei Threads muss er dieselben Bits ergeben, in einem Zehntel des Maßstabs dieselben bezogenen Zahlen</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Betrag</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>not yet possible</source>
        <translation>noch nicht möglich</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>zu tun</translation>
    </message>
    <message>
        <source>infinite</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>disc, radius %1 m</source>
        <translation>Scheibe, Halbmesser %1 m</translation>
    </message>
    <message>
        <source>polygon, %1 corners</source>
        <translation>Vieleck, %1 Ecken</translation>
    </message>
    <message>
        <source>network, %1 m²/m³ of %2 m</source>
        <translation>Netzwerk, %1 m²/m³ zu %2 m</translation>
    </message>
    <message>
        <source>; ends at %1</source>
        <translation>; endet an %1</translation>
    </message>
    <message>
        <source>; in %1</source>
        <translation>; in %1</translation>
    </message>
    <message>
        <source>κ %1</source>
        <translation>κ %1</translation>
    </message>
    <message>
        <source>Through m</source>
        <translation>Durch m</translation>
    </message>
    <message>
        <source>Persistence</source>
        <translation>Persistenz</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>%1 block</source>
        <translation>%1 Block</translation>
    </message>
    <message>
        <source>%1 blocks</source>
        <translation>%1 Blöcke</translation>
    </message>
    <message>
        <source>cannot leave</source>
        <translation>kann nicht heraus</translation>
    </message>
    <message>
        <source>removable, stable</source>
        <translation>beweglich, standsicher</translation>
    </message>
    <message>
        <source>slides, F above 1</source>
        <translation>gleitet, F über 1</translation>
    </message>
    <message>
        <source>slides, F below 1</source>
        <translation>gleitet, F unter 1</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>fällt</translation>
    </message>
    <message>
        <source>Removability</source>
        <translation>Beweglichkeit</translation>
    </message>
    <message>
        <source>1 block</source>
        <translation>1 Block</translation>
    </message>
    <message>
        <source>name of %1</source>
        <translation>Name von %1</translation>
    </message>
    <message>
        <source>blocks must have different names</source>
        <translation>Blöcke müssen verschiedene Namen haben</translation>
    </message>
    <message>
        <source>put {n} where their number shall stand: roof {n}</source>
        <translation>{n} schreiben, wo ihre Nummer stehen soll: First {n}</translation>
    </message>
    <message>
        <source>name %1</source>
        <translation>%1 benennen</translation>
    </message>
    <message>
        <source>make %1 %2</source>
        <translation>%1 %2 machen</translation>
    </message>
    <message>
        <source>give %1 the body of their solids</source>
        <translation>%1 das Verhalten ihrer Körper geben</translation>
    </message>
    <message>
        <source>change the material of %1</source>
        <translation>Werkstoff von %1 ändern</translation>
    </message>
    <message>
        <source>change the mesh size of %1</source>
        <translation>Netzweite von %1 ändern</translation>
    </message>
    <message>
        <source>excavate %1</source>
        <translation>%1 ausbrechen</translation>
    </message>
    <message>
        <source>bring back %1</source>
        <translation>%1 zurückholen</translation>
    </message>
    <message>
        <source>blocks that share no face cannot be one</source>
        <translation>Blöcke, die keine Fläche teilen, können nicht eins sein</translation>
    </message>
    <message>
        <source>select blocks that lie against each other</source>
        <translation>Blöcke wählen, die aneinander liegen</translation>
    </message>
    <message>
        <source>merge %1</source>
        <translation>Zusammenfassung %1</translation>
    </message>
    <message>
        <source>blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>look for solids that are open or overlap, and for cuts that nearly meet</source>
        <translation>nach Körpern sehen, die offen sind oder sich durchdringen, und nach Schnitten, die sich beinahe treffen</translation>
    </message>
    <message>
        <source>What a block may do; one that was chosen has the reason</source>
        <translation>Was ein Block darf; einer, der gewählt wurde, nennt den Grund</translation>
    </message>
    <message>
        <source>%1, chosen</source>
        <translation>%1, gewählt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Slender</source>
        <translation>Schlankheit</translation>
    </message>
    <message>
        <source>Longest side over 3 V / A; above %1 a block is a sliver: mesh and contact have trouble with it</source>
        <translation>Längste Seite über 3 V / A; über %1 ist ein Block ein Splitter: Netz und Kontakt haben Mühe mit ihm</translation>
    </message>
    <message>
        <source>A sliver</source>
        <translation>Ein Splitter</translation>
    </message>
    <message>
        <source>Leaves</source>
        <translation>Geht heraus</translation>
    </message>
    <message>
        <source>Whether and how it can leave its place by block theory, and on which joints</source>
        <translation>Ob und wie er nach der Blocktheorie heraus kann, und auf welchen Klüften</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Factor of safety by limit equilibrium, under its own weight; – where nothing drives it</source>
        <translation>Standsicherheit nach dem Grenzgleichgewicht, unter Eigengewicht; – wo nichts ihn treibt</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Flat faces</source>
        <translation>Ebene Flächen</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Faces against no other block</source>
        <translation>Flächen, an denen kein anderer Block liegt</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Blocks that it lies against</source>
        <translation>Blöcke, an denen er liegt</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Klüfte</translation>
    </message>
    <message>
        <source>Joints of its faces</source>
        <translation>Klüfte seiner Flächen</translation>
    </message>
    <message>
        <source>Worst</source>
        <translation>Schlechtestes</translation>
    </message>
    <message>
        <source>Least quality of its tetrahedra: 3 × inscribed over circumscribed radius, 1 of a regular one, 0 of a flat one</source>
        <translation>Geringste Güte seiner Tetraeder: 3 × Inkugel- über Umkugelhalbmesser, 1 eines regelmäßigen, 0 eines flachen</translation>
    </message>
    <message>
        <source>Angle °</source>
        <translation>Winkel °</translation>
    </message>
    <message>
        <source>Smallest angle between two faces of a tetrahedron; 70.5° of a regular one</source>
        <translation>Kleinster Winkel zwischen zwei Flächen eines Tetraeders; 70.5° eines regelmäßigen</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean quality of its tetrahedra</source>
        <translation>Mittlere Güte seiner Tetraeder</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>Of its motion</source>
        <translation>Seiner Bewegung</translation>
    </message>
    <message>
        <source>as their solids</source>
        <translation>wie ihre Körper</translation>
    </message>
    <message>
        <source>different ones</source>
        <translation>verschiedene</translation>
    </message>
    <message>
        <source>move cut %1</source>
        <translation>Schnitt %1 verschieben</translation>
    </message>
    <message>
        <source>size cut %1</source>
        <translation>Größe von Schnitt %1 ändern</translation>
    </message>
    <message>
        <source>move a corner of cut %1</source>
        <translation>Ecke von Schnitt %1 verschieben</translation>
    </message>
    <message>
        <source>turn cut %1</source>
        <translation>Schnitt %1 drehen</translation>
    </message>
    <message>
        <source>they and what was left out have %1 m³ together, the solids %2 m³</source>
        <translation>sie und was ausgelassen wurde haben zusammen %1 m³, die Körper %2 m³</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>part of %1</source>
        <translation>Teil von %1</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>splinter, %1 thick</source>
        <translation>Splitter, %1 dick</translation>
    </message>
    <message>
        <source>%1 … %2 m</source>
        <translation>%1 … %2 m</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>E %1  N %2  Z %3 m</source>
        <translation>O %1  N %2  Z %3 m</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Horizontal</source>
        <translation>Waagrecht</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>Senkrecht</translation>
    </message>
    <message>
        <source>Trend / plunge</source>
        <translation>Azimut / Einfallen</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>the three points lie in a line</source>
        <translation>die drei Punkte liegen auf einer Geraden</translation>
    </message>
    <message>
        <source>Angle at the second</source>
        <translation>Winkel am zweiten</translation>
    </message>
    <message>
        <source>Dip / direction</source>
        <translation>Fallen / Richtung</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>the cuts leave a splinter, %1 m thick</source>
        <translation>die Schnitte lassen einen Splitter, %1 m dick</translation>
    </message>
    <message>
        <source>the cuts leave %1 splinters, the thinnest %2 m thick</source>
        <translation>die Schnitte lassen %1 Splitter, der dünnste %2 m dick</translation>
    </message>
    <message>
        <source>drop them, merge them with their neighbours, or move a joint: see Splinters</source>
        <translation>weglassen, mit den Nachbarn vereinigen oder eine Kluft verschieben: siehe Splitter</translation>
    </message>
    <message>
        <source>blocks of different solids cannot be one</source>
        <translation>Blöcke verschiedener Körper können nicht einer werden</translation>
    </message>
    <message>
        <source>unite the two solids on the Geometry page, and cut what comes of it</source>
        <translation>die beiden Körper auf der Seite Geometrie vereinigen und das Ergebnis schneiden</translation>
    </message>
    <message>
        <source>The solids are being read</source>
        <translation>Die Körper werden gelesen</translation>
    </message>
    <message>
        <source>Solve page</source>
        <translation>Seite Rechnen</translation>
    </message>
    <message>
        <source>blocks lay in each other at %1 s</source>
        <translation>Blöcke lagen bei %1 s ineinander</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>not converged</source>
        <translation>nicht konvergiert</translation>
    </message>
    <message>
        <source>broken off</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>%1, spread %2</source>
        <translation>%1, Streuung %2</translation>
    </message>
    <message>
        <source>softness of contacts</source>
        <translation>Nachgiebigkeit der Kontakte</translation>
    </message>
    <message>
        <source>the known answer</source>
        <translation>der bekannten Antwort</translation>
    </message>
    <message>
        <source>run %1, the finest</source>
        <translation>Lauf %1, dem feinsten</translation>
    </message>
    <message>
        <source>; measured: %1</source>
        <translation>; gemessen: %1</translation>
    </message>
    <message>
        <source>; mean of %1 runs ± spread</source>
        <translation>; Mittel von %1 Läufen ± Streuung</translation>
    </message>
    <message>
        <source>; no better setting can be told apart</source>
        <translation>; keine bessere Einstellung ist zu erkennen</translation>
    </message>
    <message>
        <source>What is expected, else displacements</source>
        <translation>Was erwartet wird, sonst Verschiebungen</translation>
    </message>
    <message>
        <source>Run-out of the farthest block</source>
        <translation>Reichweite des weitesten Blocks</translation>
    </message>
    <message>
        <source>Deposit: where the mass lies</source>
        <translation>Ablagerung: wo die Masse liegt</translation>
    </message>
    <message>
        <source>Start of the first block</source>
        <translation>Beginn des ersten Blocks</translation>
    </message>
    <message>
        <source>End: rest of the last block</source>
        <translation>Ende: Ruhe des letzten Blocks</translation>
    </message>
    <message>
        <source>Stress at monitors</source>
        <translation>Spannung an Messpunkten</translation>
    </message>
</context>
<context>
    <name>choices</name>
    <message>
        <source>refuse</source>
        <translation>ablehnen</translation>
    </message>
    <message>
        <source>drop</source>
        <translation>weglassen</translation>
    </message>
    <message>
        <source>merge</source>
        <translation>zusammenfassen</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>affin</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>neo-hookean</source>
        <translation>neo-Hooke</translation>
    </message>
    <message>
        <source>unite</source>
        <translation>vereinigen</translation>
    </message>
    <message>
        <source>subtract</source>
        <translation>abziehen</translation>
    </message>
    <message>
        <source>intersect</source>
        <translation>schneiden</translation>
    </message>
    <message>
        <source>equal</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>exponential</source>
        <translation>exponentiell</translation>
    </message>
    <message>
        <source>lognormal</source>
        <translation>lognormal</translation>
    </message>
    <message>
        <source>one block</source>
        <translation>der eine Block</translation>
    </message>
    <message>
        <source>the other</source>
        <translation>der andere</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statisch</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamisch</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>grob</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>üblich</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>fein</translation>
    </message>
    <message>
        <source>incremental</source>
        <translation>inkrementell</translation>
    </message>
    <message>
        <source>corotational</source>
        <translation>korotational</translation>
    </message>
    <message>
        <source>newmark</source>
        <translation>Newmark</translation>
    </message>
    <message>
        <source>constant-acceleration</source>
        <translation>konstante Beschleunigung</translation>
    </message>
    <message>
        <source>generalized-alpha</source>
        <translation>Generalized-α</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>facet-wise</source>
        <translation>facettenweise</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>angepasst</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>Aufsatz</translation>
    </message>
    <message>
        <source>talus</source>
        <translation>Talus</translation>
    </message>
    <message>
        <source>newton</source>
        <translation>Newton</translation>
    </message>
    <message>
        <source>states</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>fading</source>
        <translation>schwindend</translation>
    </message>
    <message>
        <source>full</source>
        <translation>volle</translation>
    </message>
    <message>
        <source>called_for</source>
        <translation>was die Szene verlangt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
</context>
<context>
    <name>component</name>
    <message>
        <source>Von Mises</source>
        <translation>Von Mises</translation>
    </message>
    <message>
        <source>Largest principal</source>
        <translation>Größter Hauptwert</translation>
    </message>
    <message>
        <source>Smallest principal</source>
        <translation>Kleinster Hauptwert</translation>
    </message>
    <message>
        <source>Largest shear</source>
        <translation>Größter Schub</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Volumetric</source>
        <translation>Volumetrisch</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Kind of body</source>
        <translation>Art des Körpers</translation>
    </message>
    <message>
        <source>Motion of blocks</source>
        <translation>Bewegung der Blöcke</translation>
    </message>
    <message>
        <source>Normal stress</source>
        <translation>Normalspannung</translation>
    </message>
    <message>
        <source>Shear stress</source>
        <translation>Schubspannung</translation>
    </message>
    <message>
        <source>Mobilised shear strength</source>
        <translation>Ausgenutzte Scherfestigkeit</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Gleitweg</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Bonds</source>
        <translation>Bindungen</translation>
    </message>
    <message>
        <source>Cohesion left</source>
        <translation>Restkohäsion</translation>
    </message>
    <message>
        <source>Safety factor of rock</source>
        <translation>Sicherheitsfaktor des Gesteins</translation>
    </message>
    <message>
        <source>Blocks that sleep</source>
        <translation>Schlafende Blöcke</translation>
    </message>
</context>
<context>
    <name>counted</name>
    <message numerus="yes">
        <source>block</source>
        <translation>
            <numerusform>Block</numerusform>
            <numerusform>Blöcke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>corner</source>
        <translation>
            <numerusform>Ecke</numerusform>
            <numerusform>Ecken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>cut</source>
        <translation>
            <numerusform>Schnitt</numerusform>
            <numerusform>Schnitte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>error</source>
        <translation>
            <numerusform>Fehler</numerusform>
            <numerusform>Fehler</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>face</source>
        <translation>
            <numerusform>Fläche</numerusform>
            <numerusform>Flächen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>frame</source>
        <translation>
            <numerusform>Bild</numerusform>
            <numerusform>Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>hint</source>
        <translation>
            <numerusform>Hinweis</numerusform>
            <numerusform>Hinweise</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>iteration</source>
        <translation>
            <numerusform>Iteration</numerusform>
            <numerusform>Iterationen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>joint</source>
        <translation>
            <numerusform>Kluft</numerusform>
            <numerusform>Klüfte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>line</source>
        <translation>
            <numerusform>Zeile</numerusform>
            <numerusform>Zeilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>load</source>
        <translation>
            <numerusform>Last</numerusform>
            <numerusform>Lasten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>material</source>
        <translation>
            <numerusform>Werkstoff</numerusform>
            <numerusform>Werkstoffe</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>pole</source>
        <translation>
            <numerusform>Pol</numerusform>
            <numerusform>Pole</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>row</source>
        <translation>
            <numerusform>Zeile</numerusform>
            <numerusform>Zeilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>solid</source>
        <translation>
            <numerusform>Körper</numerusform>
            <numerusform>Körper</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>stage</source>
        <translation>
            <numerusform>Abschnitt</numerusform>
            <numerusform>Abschnitte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>step</source>
        <translation>
            <numerusform>Schritt</numerusform>
            <numerusform>Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>support</source>
        <translation>
            <numerusform>Lager</numerusform>
            <numerusform>Lager</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>thread</source>
        <translation>
            <numerusform>Thread</numerusform>
            <numerusform>Threads</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>time</source>
        <translation>
            <numerusform>Mal</numerusform>
            <numerusform>Mal</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>triangle</source>
        <translation>
            <numerusform>Dreieck</numerusform>
            <numerusform>Dreiecke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>warning</source>
        <translation>
            <numerusform>Warnung</numerusform>
            <numerusform>Warnungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>plane</source>
        <translation>
            <numerusform>Ebene</numerusform>
            <numerusform>Ebenen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>effects</name>
    <message>
        <source>elasticity</source>
        <translation>Elastizität</translation>
    </message>
    <message>
        <source>neo-Hookean elasticity</source>
        <translation>neo-Hookesche Elastizität</translation>
    </message>
    <message>
        <source>initial stress</source>
        <translation>Anfangsspannung</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>displacement constraint</source>
        <translation>vorgegebene Verschiebung</translation>
    </message>
    <message>
        <source>point load</source>
        <translation>Punktlast</translation>
    </message>
    <message>
        <source>body force</source>
        <translation>Volumenkraft</translation>
    </message>
    <message>
        <source>normal contact</source>
        <translation>Normalkontakt</translation>
    </message>
    <message>
        <source>shear contact</source>
        <translation>Schubkontakt</translation>
    </message>
    <message>
        <source>cohesion and tension</source>
        <translation>Kohäsion und Zugfestigkeit</translation>
    </message>
    <message>
        <source>rebound</source>
        <translation>Rückprall</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>restitution</source>
        <translation>Rückprallzahl</translation>
    </message>
    <message>
        <source>missed contacts</source>
        <translation>verpasste Kontakte</translation>
    </message>
    <message>
        <source>updated normals</source>
        <translation>nachgeführte Normalen</translation>
    </message>
    <message>
        <source>penalty scaling</source>
        <translation>Versteifung der Kontakte</translation>
    </message>
    <message>
        <source>followed springs</source>
        <translation>mitkommende Federn</translation>
    </message>
    <message>
        <source>acceleration reset</source>
        <translation>Rücksetzen der Beschleunigung</translation>
    </message>
    <message>
        <source>sleep</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>nonlinear elimination</source>
        <translation>nichtlineare Elimination</translation>
    </message>
</context>
<context>
    <name>grammar</name>
    <message>
        <source>lower case</source>
        <translation>Großschreibung</translation>
    </message>
</context>
<context>
    <name>pages</name>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Klüfte</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Werkstoffe</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>Lasten</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
</context>
<context>
    <name>picture</name>
    <message>
        <source>event in the reference</source>
        <translation>Ereignis der Vergleichsquelle</translation>
    </message>
    <message>
        <source>computed event</source>
        <translation>berechnetes Ereignis</translation>
    </message>
    <message>
        <source>x east</source>
        <translation>x Ost</translation>
    </message>
    <message>
        <source>y north</source>
        <translation>y Nord</translation>
    </message>
    <message>
        <source>z up</source>
        <translation>z oben</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Stress, tension positive</source>
        <translation>Spannung, Zug positiv</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>rounding</source>
        <translation>Rundung</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>best for its cost</source>
        <translation>beste für ihren Aufwand</translation>
    </message>
    <message>
        <source>Processor time of solving</source>
        <translation>Rechenzeit des Prozessors</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>Distance along the line</source>
        <translation>Weg entlang der Linie</translation>
    </message>
    <message>
        <source>Depth of the deposit at</source>
        <translation>Mächtigkeit der Ablagerung bei</translation>
    </message>
    <message>
        <source>East, x</source>
        <translation>Ost, x</translation>
    </message>
    <message>
        <source>North, y</source>
        <translation>Nord, y</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Mächtigkeit</translation>
    </message>
    <message>
        <source>deposit</source>
        <translation>Ablagerung</translation>
    </message>
    <message>
        <source>the rock at rest</source>
        <translation>der Fels in Ruhe</translation>
    </message>
    <message>
        <source>crown to toe</source>
        <translation>Anriss bis Fuß</translation>
    </message>
    <message>
        <source>Velocity of the front</source>
        <translation>Geschwindigkeit der Front</translation>
    </message>
    <message>
        <source>Velocity, forward</source>
        <translation>Geschwindigkeit, vorwärts</translation>
    </message>
    <message>
        <source>front</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>sticks</source>
        <translation>haftet</translation>
    </message>
    <message>
        <source>slides</source>
        <translation>gleitet</translation>
    </message>
    <message>
        <source>bonded</source>
        <translation>gebunden</translation>
    </message>
    <message>
        <source>never bonded</source>
        <translation>nie gebunden</translation>
    </message>
    <message>
        <source>broken</source>
        <translation>gebrochen</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>affin</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>awake</source>
        <translation>wach</translation>
    </message>
    <message>
        <source>asleep</source>
        <translation>schläft</translation>
    </message>
    <message>
        <source>of real time</source>
        <translation>der Echtzeit</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>E</source>
        <translation>O</translation>
    </message>
    <message>
        <source>longest</source>
        <translation>längster</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>support</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>stress in situ</source>
        <translation>Gebirgsspannung</translation>
    </message>
    <message>
        <source>monitor</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>principal stresses</source>
        <translation>Hauptspannungen</translation>
    </message>
    <message>
        <source>contact force</source>
        <translation>Kontaktkraft</translation>
    </message>
    <message>
        <source>displacements</source>
        <translation>Verschiebungen</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>stick</source>
        <translation>haftend</translation>
    </message>
    <message>
        <source>slip</source>
        <translation>gleitend</translation>
    </message>
    <message>
        <source>axes of rotation</source>
        <translation>Drehachsen</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>schnellste</translation>
    </message>
    <message>
        <source>face</source>
        <translation>Böschung</translation>
    </message>
    <message>
        <source>daylight envelope of its poles</source>
        <translation>Daylight-Hüllkurve ihrer Pole</translation>
    </message>
    <message>
        <source>friction cone φ</source>
        <translation>Reibungskegel φ</translation>
    </message>
    <message>
        <source>slip limit, face dip − φ</source>
        <translation>Gleitgrenze, Böschungsfallen − φ</translation>
    </message>
    <message>
        <source>lateral limits</source>
        <translation>seitliche Grenzen</translation>
    </message>
    <message>
        <source>intersections of mean planes</source>
        <translation>Schnittgeraden der mittleren Ebenen</translation>
    </message>
    <message>
        <source>intersections of joints</source>
        <translation>Schnittgeraden der Klüfte</translation>
    </message>
    <message>
        <source>Displacement x</source>
        <translation>Verschiebung x</translation>
    </message>
    <message>
        <source>Displacement y</source>
        <translation>Verschiebung y</translation>
    </message>
    <message>
        <source>Displacement z</source>
        <translation>Verschiebung z</translation>
    </message>
    <message>
        <source>Velocity x</source>
        <translation>Geschwindigkeit x</translation>
    </message>
    <message>
        <source>Velocity y</source>
        <translation>Geschwindigkeit y</translation>
    </message>
    <message>
        <source>Velocity z</source>
        <translation>Geschwindigkeit z</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Von-Mises-Spannung</translation>
    </message>
    <message>
        <source>Largest principal stress</source>
        <translation>Größte Hauptspannung</translation>
    </message>
    <message>
        <source>Smallest principal stress</source>
        <translation>Kleinste Hauptspannung</translation>
    </message>
    <message>
        <source>Largest shear stress</source>
        <translation>Größte Schubspannung</translation>
    </message>
    <message>
        <source>Mean stress</source>
        <translation>Mittlere Spannung</translation>
    </message>
    <message>
        <source>Stress xx</source>
        <translation>Spannung xx</translation>
    </message>
    <message>
        <source>Stress yy</source>
        <translation>Spannung yy</translation>
    </message>
    <message>
        <source>Stress zz</source>
        <translation>Spannung zz</translation>
    </message>
    <message>
        <source>Stress xy</source>
        <translation>Spannung xy</translation>
    </message>
    <message>
        <source>Stress yz</source>
        <translation>Spannung yz</translation>
    </message>
    <message>
        <source>Stress zx</source>
        <translation>Spannung zx</translation>
    </message>
    <message>
        <source>Safety factor of rock</source>
        <translation>Sicherheitsfaktor des Gesteins</translation>
    </message>
    <message>
        <source>Volumetric strain</source>
        <translation>Volumendehnung</translation>
    </message>
    <message>
        <source>Largest principal strain</source>
        <translation>Größte Hauptdehnung</translation>
    </message>
    <message>
        <source>Smallest principal strain</source>
        <translation>Kleinste Hauptdehnung</translation>
    </message>
    <message>
        <source>Largest shear strain</source>
        <translation>Größte Gleitung</translation>
    </message>
    <message>
        <source>Kind of body</source>
        <translation>Art des Körpers</translation>
    </message>
    <message>
        <source>Motion of blocks</source>
        <translation>Bewegung der Blöcke</translation>
    </message>
    <message>
        <source>Blocks that sleep</source>
        <translation>Schlafende Blöcke</translation>
    </message>
    <message>
        <source>Normal stress on joints</source>
        <translation>Normalspannung auf Klüften</translation>
    </message>
    <message>
        <source>Shear stress on joints</source>
        <translation>Schubspannung auf Klüften</translation>
    </message>
    <message>
        <source>Mobilised shear strength</source>
        <translation>Ausgenutzte Scherfestigkeit</translation>
    </message>
    <message>
        <source>Slip of joints</source>
        <translation>Gleitweg der Klüfte</translation>
    </message>
    <message>
        <source>Opening of joints</source>
        <translation>Öffnung der Klüfte</translation>
    </message>
    <message>
        <source>State of joints</source>
        <translation>Zustand der Klüfte</translation>
    </message>
    <message>
        <source>Bonds of joints</source>
        <translation>Bindungen der Klüfte</translation>
    </message>
    <message>
        <source>Cohesion left</source>
        <translation>Restkohäsion</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Kinetische Energie</translation>
    </message>
    <message>
        <source>Largest von Mises stress</source>
        <translation>Größte Von-Mises-Spannung</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>Kontaktkraft</translation>
    </message>
    <message>
        <source>Normal forces, summed</source>
        <translation>Normalkräfte, Summe</translation>
    </message>
    <message>
        <source>Shear forces, summed</source>
        <translation>Schubkräfte, Summe</translation>
    </message>
    <message>
        <source>which blocks sleep is not recorded in these results: an earlier version of Talus has written them</source>
        <translation>welche Blöcke schlafen, ist in diesen Ergebnissen nicht festgehalten: eine frühere Version von Talus hat sie geschrieben</translation>
    </message>
    <message>
        <source>no material has a strength: give one to the rock on the page Materials</source>
        <translation>kein Material hat eine Festigkeit: auf der Seite Werkstoffe kann das Gestein eine bekommen</translation>
    </message>
    <message>
        <source>how blocks move was not noted in this frame</source>
        <translation>wie sich Blöcke bewegen, ist in diesem Bild nicht festgehalten</translation>
    </message>
    <message>
        <source>these results do not tell of the strength of joints: an earlier version of Talus has written them</source>
        <translation>diese Ergebnisse sagen nichts über die Festigkeit der Klüfte: eine frühere Version von Talus hat sie geschrieben</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stabil</translation>
    </message>
    <message>
        <source>carried</source>
        <translation>getragen</translation>
    </message>
    <message>
        <source>falling</source>
        <translation>fallend</translation>
    </message>
    <message>
        <source>sliding on one plane</source>
        <translation>gleitet auf einer Fläche</translation>
    </message>
    <message>
        <source>sliding on two planes</source>
        <translation>gleitet auf zwei Flächen</translation>
    </message>
    <message>
        <source>toppling</source>
        <translation>kippt</translation>
    </message>
    <message>
        <source>torsional</source>
        <translation>dreht sich auf der Fläche</translation>
    </message>
    <message>
        <source>sliding and toppling</source>
        <translation>gleitet und kippt</translation>
    </message>
    <message>
        <source>sliding and torsional</source>
        <translation>gleitet und dreht sich</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Scharen</translation>
    </message>
    <message>
        <source>mean dip/direction · κ</source>
        <translation>mittleres Fallen/Richtung · κ</translation>
    </message>
    <message>
        <source>no set</source>
        <translation>keine Schar</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Böschung</translation>
    </message>
    <message>
        <source>Critical</source>
        <translation>Kritisch</translation>
    </message>
    <message>
        <source>equal area</source>
        <translation>flächentreu</translation>
    </message>
    <message>
        <source>equal angle</source>
        <translation>winkeltreu</translation>
    </message>
    <message>
        <source>lower hemisphere</source>
        <translation>untere Halbkugel</translation>
    </message>
    <message>
        <source>planar sliding</source>
        <translation>Gleiten auf einer Fläche</translation>
    </message>
    <message>
        <source>planar, no limits</source>
        <translation>eine Fläche, ohne Grenzen</translation>
    </message>
    <message>
        <source>wedge sliding</source>
        <translation>Keilgleiten</translation>
    </message>
    <message>
        <source>flexural toppling</source>
        <translation>Biegekippen</translation>
    </message>
    <message>
        <source>direct toppling</source>
        <translation>Blockkippen</translation>
    </message>
    <message>
        <source>base planes</source>
        <translation>Basisflächen</translation>
    </message>
    <message>
        <source>pole</source>
        <translation>Pol</translation>
    </message>
    <message>
        <source>poles</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>critical intersections</source>
        <translation>kritische Schnittlinien</translation>
    </message>
    <message>
        <source>critical poles</source>
        <translation>kritische Pole</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>densest</source>
        <translation>dichteste Stelle</translation>
    </message>
    <message>
        <source>too many intersections of single joints to be drawn</source>
        <translation>zu viele Schnitte einzelner Klüfte für eine Zeichnung</translation>
    </message>
    <message>
        <source>% per 1 % area</source>
        <translation>% je 1 % der Fläche</translation>
    </message>
    <message>
        <source>north</source>
        <translation>Norden</translation>
    </message>
</context>
<context>
    <name>quantity</name>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Displacement x</source>
        <translation>Verschiebung x</translation>
    </message>
    <message>
        <source>Displacement y</source>
        <translation>Verschiebung y</translation>
    </message>
    <message>
        <source>Displacement z</source>
        <translation>Verschiebung z</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Velocity x</source>
        <translation>Geschwindigkeit x</translation>
    </message>
    <message>
        <source>Velocity y</source>
        <translation>Geschwindigkeit y</translation>
    </message>
    <message>
        <source>Velocity z</source>
        <translation>Geschwindigkeit z</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Bewegungsenergie</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>Kontaktkraft</translation>
    </message>
    <message>
        <source>Largest von Mises stress</source>
        <translation>Größte von-Mises-Spannung</translation>
    </message>
    <message>
        <source>Normal forces, summed</source>
        <translation>Normalkräfte, summiert</translation>
    </message>
    <message>
        <source>Shear forces, summed</source>
        <translation>Schubkräfte, summiert</translation>
    </message>
</context>
<context>
    <name>saveTable</name>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
</context>
<context>
    <name>schema</name>
    <message>
        <source>Talus project</source>
        <translation>Talus-Projekt</translation>
    </message>
    <message>
        <source>A rock slope and how it is to be run. SI units; angles in degrees; x east, y north, z up. Comments are allowed in the file.</source>
        <translation>Ein Felshang und wie er zu rechnen ist. SI-Einheiten; Winkel in Grad; x Ost, y Nord, z aufwärts. In der Datei sind Kommentare erlaubt.</translation>
    </message>
    <message>
        <source>File format</source>
        <translation>Dateiformat</translation>
    </message>
    <message>
        <source>version of the file format: 1</source>
        <translation>Version des Dateiformats: 1</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>title of the project</source>
        <translation>Titel des Projekts</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>acceleration of gravity, m/s²: [0, 0, -9.81] when absent</source>
        <translation>Erdbeschleunigung, m/s²: [0, 0, -9.81], wenn sie fehlt</translation>
    </message>
    <message>
        <source>Local origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>where the project&apos;s coordinates begin in those of its files, m: what is read from a file is less this: [0, 0, 0] when absent</source>
        <translation>wo die Koordinaten des Projekts in denen seiner Dateien beginnen, m: was aus einer Datei gelesen wird, wird um ihn vermindert: [0, 0, 0], wenn er fehlt</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Werkstoffe</translation>
    </message>
    <message>
        <source>rock by name</source>
        <translation>Fels nach Namen</translation>
    </message>
    <message>
        <source>Joint properties</source>
        <translation>Klufteigenschaften</translation>
    </message>
    <message>
        <source>joint properties by name</source>
        <translation>Eigenschaften von Klüften nach Namen</translation>
    </message>
    <message>
        <source>Default joint</source>
        <translation>Übliche Kluft</translation>
    </message>
    <message>
        <source>name of the joint for contacts on no cut and no interface</source>
        <translation>Name der Kluft für Kontakte auf keinem Schnitt und keiner Grenzfläche</translation>
    </message>
    <message>
        <source>Solids</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>the bodies of rock before they are cut</source>
        <translation>die Felskörper, bevor sie geschnitten werden</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>joint planes that divide the solids and give their joint to the facets on them</source>
        <translation>Kluftebenen, die die Körper teilen und den Facetten auf ihnen ihre Kluft geben</translation>
    </message>
    <message>
        <source>Named blocks</source>
        <translation>Benannte Blöcke</translation>
    </message>
    <message>
        <source>names and overrides for single blocks</source>
        <translation>Namen und Abweichungen einzelner Blöcke</translation>
    </message>
    <message>
        <source>Merged blocks</source>
        <translation>Zusammengefasste Blöcke</translation>
    </message>
    <message>
        <source>pairs of blocks that share a face and are made one</source>
        <translation>Paare von Blöcken, die eine Fläche teilen und eins werden</translation>
    </message>
    <message>
        <source>Splinters</source>
        <translation>Splitter</translation>
    </message>
    <message>
        <source>Thinner than</source>
        <translation>Dünner als</translation>
    </message>
    <message>
        <source>a block thinner than this is a splinter, m: 1e-4 of the mesh size when absent</source>
        <translation>ein dünnerer Block ist ein Splitter, m: 1e-4 der Netzweite, wenn es fehlt</translation>
    </message>
    <message>
        <source>1e-4 of the mesh size</source>
        <translation>1e-4 der Netzweite</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>refuse tells where they are and cuts nothing; drop leaves them out; merge makes each one with the block that it shares most of its surface with: drop when absent</source>
        <translation>ablehnen sagt, wo sie sind, und schneidet nichts; weglassen lässt sie aus; zusammenfassen macht jeden eins mit dem Block, mit dem er am meisten Oberfläche teilt: weglassen, wenn es fehlt</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>how finely blocks are meshed</source>
        <translation>wie fein Blöcke vernetzt werden</translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation>Netzweite</translation>
    </message>
    <message>
        <source>edge length of the tetrahedra of solids that say none, m: a tenth of a solid&apos;s longest side when absent</source>
        <translation>Kantenlänge der Tetraeder von Körpern, die keine nennen, m: ein Zehntel der längsten Seite eines Körpers, wenn sie fehlt</translation>
    </message>
    <message>
        <source>by solid</source>
        <translation>je Körper</translation>
    </message>
    <message>
        <source>a mesh that would have more tetrahedra is refused: 5000000 when absent</source>
        <translation>ein Netz mit mehr Tetraedern wird abgelehnt: 5000000, wenn es fehlt</translation>
    </message>
    <message>
        <source>Interfaces</source>
        <translation>Grenzflächen</translation>
    </message>
    <message>
        <source>joints of block pairs that touch on no cut</source>
        <translation>Klüfte von Blockpaaren, die sich auf keinem Schnitt berühren</translation>
    </message>
    <message>
        <source>Supports</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>points that are held or moved, and fixed blocks that are moved</source>
        <translation>Punkte, die festgehalten oder bewegt werden, und feste Blöcke, die bewegt werden</translation>
    </message>
    <message>
        <source>Point loads</source>
        <translation>Punktlasten</translation>
    </message>
    <message>
        <source>point loads</source>
        <translation>Punktlasten</translation>
    </message>
    <message>
        <source>Initial velocities</source>
        <translation>Anfangsgeschwindigkeiten</translation>
    </message>
    <message>
        <source>velocities of blocks at the start</source>
        <translation>Geschwindigkeiten von Blöcken am Anfang</translation>
    </message>
    <message>
        <source>Stress in situ</source>
        <translation>Primärspannung</translation>
    </message>
    <message>
        <source>stress in the rock before the run</source>
        <translation>Spannung im Fels vor dem Lauf</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>what is run, in order</source>
        <translation>was gerechnet wird, der Reihe nach</translation>
    </message>
    <message>
        <source>Monitors</source>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>points whose history is recorded</source>
        <translation>Punkte, deren Verlauf aufgezeichnet wird</translation>
    </message>
    <message>
        <source>Expected values</source>
        <translation>Erwartete Werte</translation>
    </message>
    <message>
        <source>numbers the run must come to</source>
        <translation>Zahlen, zu denen der Lauf kommen muss</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>what is written</source>
        <translation>was geschrieben wird</translation>
    </message>
    <message>
        <source>Frame every</source>
        <translation>Bild alle</translation>
    </message>
    <message>
        <source>model time between frames, s: 0.1 when absent</source>
        <translation>Modellzeit zwischen Bildern, s: 0.1, wenn sie fehlt</translation>
    </message>
    <message>
        <source>three numbers [x, y, z]</source>
        <translation>drei Zahlen [x, y, z]</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>six numbers [xx, yy, zz, xy, yz, zx], tension positive</source>
        <translation>sechs Zahlen [xx, yy, zz, xy, yz, zx], Zug positiv</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>the point [x, y, z], m</source>
        <translation>der Punkt [x, y, z], m</translation>
    </message>
    <message>
        <source>coordinate, m</source>
        <translation>Koordinate, m</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>name of a block: of a solid left whole, of an override, or solid.1, solid.2 … for pieces</source>
        <translation>Name eines Blocks: eines ungeschnittenen Körpers, einer Abweichung, oder Körper.1, Körper.2 … für Stücke</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>how much the block may do: fixed, rigid, affine, tetrahedra, or auto, which chooses from what the project asks of it</source>
        <translation>wie viel der Block darf: fest, starr, affin, Tetraeder, oder automatisch, was nach dem wählt, was das Projekt von ihm verlangt</translation>
    </message>
    <message>
        <source>edge length of the tetrahedra, m: a tenth of the solid&apos;s longest side, or for rigid and affine blocks as coarse as their shape allows, when absent</source>
        <translation>Kantenlänge der Tetraeder, m: ein Zehntel der längsten Seite des Körpers, oder für starre und affine Blöcke so grob, wie ihre Form erlaubt, wenn sie fehlt</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>selbsttätig</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>an object with density, young and poisson</source>
        <translation>ein Objekt mit density, young und poisson</translation>
    </message>
    <message>
        <source>Density ρ</source>
        <translation>Dichte ρ</translation>
    </message>
    <message>
        <source>density, kg/m³ (rock 2600)</source>
        <translation>Dichte, kg/m³ (Fels 2600)</translation>
    </message>
    <message>
        <source>Young E</source>
        <translation>E-Modul E</translation>
    </message>
    <message>
        <source>Young&apos;s modulus, Pa (rock 25e9)</source>
        <translation>Elastizitätsmodul, Pa (Fels 25e9)</translation>
    </message>
    <message>
        <source>Poisson ν</source>
        <translation>Querdehnzahl ν</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio (rock 0.1 to 0.35; 0.49 for nearly incompressible)</source>
        <translation>Querdehnzahl (Fels 0.1 bis 0.35; 0.49 für nahezu unzusammendrückbar)</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>damping of the mass, 1/s: 0 when absent</source>
        <translation>Dämpfung der Masse, 1/s: 0, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>Gesetz</translation>
    </message>
    <message>
        <source>linear, in the rotated frame; or neo-hookean, which stiffens under compression, for strains above a few percent: linear when absent</source>
        <translation>linear, im gedrehten System; oder neo-Hooke, das unter Druck steifer wird, für Dehnungen über einigen Prozent: linear, wenn es fehlt</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Kluft</translation>
    </message>
    <message>
        <source>an object with friction_angle and what else the joint has</source>
        <translation>ein Objekt mit friction_angle und was die Kluft sonst hat</translation>
    </message>
    <message>
        <source>Friction angle φ</source>
        <translation>Reibungswinkel φ</translation>
    </message>
    <message>
        <source>friction angle, degrees</source>
        <translation>Reibungswinkel, Grad</translation>
    </message>
    <message>
        <source>Cohesion c</source>
        <translation>Kohäsion c</translation>
    </message>
    <message>
        <source>cohesion, Pa: 0 when absent</source>
        <translation>Kohäsion, Pa: 0, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Zugfestigkeit</translation>
    </message>
    <message>
        <source>tensile strength, Pa: 0 when absent</source>
        <translation>Zugfestigkeit, Pa: 0, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Residual φ</source>
        <translation>Rest-φ</translation>
    </message>
    <message>
        <source>friction angle once cohesion is broken, degrees: friction_angle when absent</source>
        <translation>Reibungswinkel, wenn die Kohäsion gebrochen ist, Grad: friction_angle, wenn er fehlt</translation>
    </message>
    <message>
        <source>as φ</source>
        <translation>wie φ</translation>
    </message>
    <message>
        <source>Normal stiffness</source>
        <translation>Normalsteifigkeit</translation>
    </message>
    <message>
        <source>normal stiffness, Pa/m: from the rock&apos;s stiffness when absent</source>
        <translation>Normalsteifigkeit, Pa/m: aus der Steifigkeit des Felses, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Shear stiffness</source>
        <translation>Schubsteifigkeit</translation>
    </message>
    <message>
        <source>shear stiffness, Pa/m: from the rock&apos;s stiffness when absent</source>
        <translation>Schubsteifigkeit, Pa/m: aus der Steifigkeit des Felses, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>Rückprall</translation>
    </message>
    <message>
        <source>speed at which blocks part after an impact over that at which they met: as their stiffness makes them when absent; rigid blocks then stay where a contact too stiff for the step stops them</source>
        <translation>Geschwindigkeit, mit der Blöcke nach einem Stoß auseinandergehen, bezogen auf die, mit der sie sich trafen: wie ihre Steifigkeit sie macht, wenn sie fehlt</translation>
    </message>
    <message>
        <source>by stiffness</source>
        <translation>nach Steifigkeit</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>an object with a name, a material and one shape</source>
        <translation>ein Objekt mit Name, Werkstoff und einer Form</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>a box with its edges along the axes: {&quot;min&quot;: [x, y, z], &quot;max&quot;: [x, y, z]}, m</source>
        <translation>ein Quader mit Kanten entlang der Achsen: {&quot;min&quot;: [x, y, z], &quot;max&quot;: [x, y, z]}, m</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Polyhedron</source>
        <translation>Polyeder</translation>
    </message>
    <message>
        <source>plane faces around a volume: {&quot;vertices&quot;: [[x, y, z], …], &quot;faces&quot;: [[0, 1, 2], …]}</source>
        <translation>ebene Flächen um ein Volumen: {&quot;vertices&quot;: [[x, y, z], …], &quot;faces&quot;: [[0, 1, 2], …]}</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>points [x, y, z], m</source>
        <translation>Punkte [x, y, z], m</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>polygons of vertex numbers from 0, counter-clockwise seen from outside</source>
        <translation>Vielecke aus Nummern der Ecken von 0 an, von außen gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>a list of at least 3 vertex numbers</source>
        <translation>eine Liste von mindestens 3 Nummern von Ecken</translation>
    </message>
    <message>
        <source>number of a vertex, from 0</source>
        <translation>Nummer einer Ecke, von 0 an</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>STEP, IGES, BREP, STL, OBJ, PLY or MSH file, its path relative to the project&apos;s folder</source>
        <translation>STEP-, IGES-, BREP-, STL-, OBJ-, PLY- oder MSH-Datei, ihr Pfad vom Ordner des Projekts aus</translation>
    </message>
    <message>
        <source>Solids (*.step *.stp *.iges *.igs *.brep *.stl *.obj *.ply *.msh)</source>
        <translation>Körper (*.step *.stp *.iges *.igs *.brep *.stl *.obj *.ply *.msh)</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>metres per unit of the file: 1 when absent</source>
        <translation>Meter je Einheit der Datei: 1, wenn er fehlt</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>rock below a surface of the ground: {&quot;file&quot;: &quot;ground.asc&quot;, &quot;base&quot;: 100}</source>
        <translation>Fels unter einer Geländeoberfläche: {&quot;file&quot;: &quot;ground.asc&quot;, &quot;base&quot;: 100}</translation>
    </message>
    <message>
        <source>grid of heights (ESRI ASCII, GeoTIFF), points (XYZ) or triangles (STL, OBJ, PLY), its path relative to the project&apos;s folder</source>
        <translation>Höhenraster (ESRI ASCII, GeoTIFF), Punkte (XYZ) oder Dreiecke (STL, OBJ, PLY), der Pfad vom Ordner des Projekts aus</translation>
    </message>
    <message>
        <source>Terrain (*.asc *.tif *.tiff *.xyz *.csv *.txt *.stl *.obj *.ply)</source>
        <translation>Gelände (*.asc *.tif *.tiff *.xyz *.csv *.txt *.stl *.obj *.ply)</translation>
    </message>
    <message>
        <source>Base z</source>
        <translation>Sohle z</translation>
    </message>
    <message>
        <source>height of the flat underside, m, below all of the surface</source>
        <translation>Höhe der ebenen Unterseite, m, unter der ganzen Oberfläche</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>how far the thinned surface may lie from what the file has, m: 0, every point is kept, when absent</source>
        <translation>wie weit die ausgedünnte Oberfläche von der Datei abweichen darf, m: 0, jeder Punkt bleibt, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>a prism whose corners lie on a circle around the axis: {&quot;from&quot;: [x, y, z], &quot;to&quot;: [x, y, z], &quot;radius&quot;: r}, m</source>
        <translation>ein Prisma, dessen Ecken auf einem Kreis um die Achse liegen: {&quot;from&quot;: [x, y, z], &quot;to&quot;: [x, y, z], &quot;radius&quot;: r}, m</translation>
    </message>
    <message>
        <source>Axis from</source>
        <translation>Achse von</translation>
    </message>
    <message>
        <source>Axis to</source>
        <translation>Achse bis</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Halbmesser</translation>
    </message>
    <message>
        <source>radius, m</source>
        <translation>Halbmesser, m</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>plane faces around it: 24 when absent</source>
        <translation>ebene Flächen ringsum: 24, wenn es fehlt</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>a closed vertical section that is extruded: {&quot;points&quot;: [[d, h], …], &quot;origin&quot;: [x, y, z], &quot;azimuth&quot;: 90, &quot;width&quot;: w}</source>
        <translation>ein geschlossenes senkrechtes Profil, das in die Breite gezogen wird: {&quot;points&quot;: [[d, h], …], &quot;origin&quot;: [x, y, z], &quot;azimuth&quot;: 90, &quot;width&quot;: w}</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>distance along the section and height, m, in order around it</source>
        <translation>Entfernung entlang des Profils und Höhe, m, der Reihe nach ringsum</translation>
    </message>
    <message>
        <source>a corner [d, h], m</source>
        <translation>eine Ecke [d, h], m</translation>
    </message>
    <message>
        <source>distance or height, m</source>
        <translation>Entfernung oder Höhe, m</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>the point [x, y, z] at which distance and height are zero, m</source>
        <translation>der Punkt [x, y, z], an dem Entfernung und Höhe null sind, m</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>direction in which the distance grows, degrees clockwise from north</source>
        <translation>Richtung, in der die Entfernung wächst, Grad im Uhrzeigersinn von Nord</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>across the section, half of it to each side, m</source>
        <translation>quer zum Profil, die Hälfte nach jeder Seite, m</translation>
    </message>
    <message>
        <source>Combined</source>
        <translation>Verknüpft</translation>
    </message>
    <message>
        <source>made of other solids, which are no bodies of their own then: {&quot;operation&quot;: &quot;subtract&quot;, &quot;solids&quot;: [&quot;rock&quot;, &quot;tunnel&quot;]}</source>
        <translation>aus anderen Körpern gemacht, die dann selbst keine mehr sind: {&quot;operation&quot;: &quot;subtract&quot;, &quot;solids&quot;: [&quot;rock&quot;, &quot;tunnel&quot;]}</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Verknüpfung</translation>
    </message>
    <message>
        <source>unite, subtract the others from the first, or intersect</source>
        <translation>vereinigen, die anderen vom ersten abziehen, oder schneiden</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>names of solids that stand before it</source>
        <translation>Namen von Körpern, die davor stehen</translation>
    </message>
    <message>
        <source>name of a solid</source>
        <translation>Name eines Körpers</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>turned by the right hand about an axis, before it is moved</source>
        <translation>rechtshändig um eine Achse gedreht, bevor er verschoben wird</translation>
    </message>
    <message>
        <source>not turned</source>
        <translation>nicht gedreht</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>direction [x, y, z] of the axis, of any length</source>
        <translation>Richtung [x, y, z] der Achse, beliebig lang</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>angle, degrees</source>
        <translation>Winkel, Grad</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>a point of the axis, m: [0, 0, 0] when absent</source>
        <translation>ein Punkt der Achse, m: [0, 0, 0], wenn er fehlt</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>Verschoben</translation>
    </message>
    <message>
        <source>by [x, y, z], m: [0, 0, 0] when absent</source>
        <translation>um [x, y, z], m: [0, 0, 0], wenn es fehlt</translation>
    </message>
    <message>
        <source>name of one of the materials</source>
        <translation>Name eines der Werkstoffe</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>an object with joint, dip, dip_direction and through</source>
        <translation>ein Objekt mit joint, dip, dip_direction und through</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>name of one of the joints</source>
        <translation>Name einer der Klüfte</translation>
    </message>
    <message>
        <source>Dip</source>
        <translation>Fallen</translation>
    </message>
    <message>
        <source>dip from the horizontal, 0 to 90 degrees</source>
        <translation>Fallen gegen die Waagrechte, 0 bis 90 Grad</translation>
    </message>
    <message>
        <source>Dip direction</source>
        <translation>Fallrichtung</translation>
    </message>
    <message>
        <source>dip direction, clockwise from north (+y), 0 to 360 degrees</source>
        <translation>Fallrichtung, im Uhrzeigersinn von Nord (+y), 0 bis 360 Grad</translation>
    </message>
    <message>
        <source>Through</source>
        <translation>Durch</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>distance of parallel planes along the upward normal, m</source>
        <translation>Abstand paralleler Ebenen entlang der aufwärts weisenden Normalen, m</translation>
    </message>
    <message>
        <source>one plane</source>
        <translation>eine Ebene</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>number of parallel planes</source>
        <translation>Anzahl paralleler Ebenen</translation>
    </message>
    <message>
        <source>Law of spacing</source>
        <translation>Abstandsgesetz</translation>
    </message>
    <message>
        <source>how the spacing varies about its mean: equal when absent</source>
        <translation>wie der Abstand um sein Mittel schwankt: gleich, wenn es fehlt</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>standard deviation of a normal or lognormal spacing, m: half the spacing when absent</source>
        <translation>Standardabweichung eines normal oder lognormal verteilten Abstands, m: der halbe Abstand, wenn sie fehlt</translation>
    </message>
    <message>
        <source>half the spacing</source>
        <translation>der halbe Abstand</translation>
    </message>
    <message>
        <source>Scatter κ</source>
        <translation>Streuung κ</translation>
    </message>
    <message>
        <source>scatter of the planes&apos; poles about the mean attitude, Fisher&apos;s κ: all are parallel when absent</source>
        <translation>Streuung der Pole der Ebenen um die mittlere Stellung, Fishers κ: alle sind parallel, wenn sie fehlt</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallel</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>of what is drawn by chance, the same planes for the same seed: 1 when absent</source>
        <translation>des Zufalls, dieselben Ebenen für dieselbe Zahl: 1, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>Scheibe</translation>
    </message>
    <message>
        <source>it ends at a circle: {&quot;centre&quot;: [x, y, z], &quot;radius&quot;: r}, m</source>
        <translation>sie endet an einem Kreis: {&quot;centre&quot;: [x, y, z], &quot;radius&quot;: r}, m</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Vieleck</translation>
    </message>
    <message>
        <source>it ends at a polygon: corners [x, y, z] in order, m, put onto the plane of dip and dip_direction through their mean</source>
        <translation>sie endet an einem Vieleck: Ecken [x, y, z] der Reihe nach, m, auf die Ebene von dip und dip_direction durch ihr Mittel gelegt</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Netzwerk</translation>
    </message>
    <message>
        <source>discs by chance in a box, as many as its density asks for</source>
        <translation>zufällige Scheiben in einem Quader, so viele, wie ihre Dichte verlangt</translation>
    </message>
    <message>
        <source>In the box</source>
        <translation>Im Quader</translation>
    </message>
    <message>
        <source>where the discs have their centres: {&quot;min&quot;: [x, y, z], &quot;max&quot;: [x, y, z]}, m</source>
        <translation>wo die Scheiben ihre Mitten haben: {&quot;min&quot;: [x, y, z], &quot;max&quot;: [x, y, z]}, m</translation>
    </message>
    <message>
        <source>Density P32</source>
        <translation>Dichte P32</translation>
    </message>
    <message>
        <source>area of joints per volume of the box, m²/m³</source>
        <translation>Kluftfläche je Volumen des Quaders, m²/m³</translation>
    </message>
    <message>
        <source>Mean radius</source>
        <translation>Mittlerer Halbmesser</translation>
    </message>
    <message>
        <source>mean radius of the discs, m</source>
        <translation>mittlerer Halbmesser der Scheiben, m</translation>
    </message>
    <message>
        <source>Law of radius</source>
        <translation>Halbmessergesetz</translation>
    </message>
    <message>
        <source>how the radius varies about its mean: equal when absent</source>
        <translation>wie der Halbmesser um sein Mittel schwankt: gleich, wenn es fehlt</translation>
    </message>
    <message>
        <source>standard deviation of a lognormal radius, m: half the mean when absent</source>
        <translation>Standardabweichung eines lognormal verteilten Halbmessers, m: das halbe Mittel, wenn sie fehlt</translation>
    </message>
    <message>
        <source>half the radius</source>
        <translation>der halbe Halbmesser</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Endet an</translation>
    </message>
    <message>
        <source>names of joints: it ends where it meets their cuts, on the side of its own point: it goes through when absent</source>
        <translation>Namen von Klüften: sie endet, wo sie deren Schnitte trifft, auf der Seite ihres eigenen Punktes: sie geht durch, wenn es fehlt</translation>
    </message>
    <message>
        <source>goes through</source>
        <translation>geht durch</translation>
    </message>
    <message>
        <source>Divides</source>
        <translation>Teilt</translation>
    </message>
    <message>
        <source>names of the solids the cut is limited to: all when absent</source>
        <translation>Namen der Körper, auf die der Schnitt beschränkt ist: alle, wenn es fehlt</translation>
    </message>
    <message>
        <source>every solid</source>
        <translation>alle Körper</translation>
    </message>
    <message>
        <source>Named block</source>
        <translation>Benannter Block</translation>
    </message>
    <message>
        <source>an object with a name and a point &apos;at&apos; inside the block</source>
        <translation>ein Objekt mit einem Namen und einem Punkt &apos;at&apos; im Block</translation>
    </message>
    <message>
        <source>as its solid</source>
        <translation>wie sein Körper</translation>
    </message>
    <message>
        <source>Excavated</source>
        <translation>Ausgebrochen</translation>
    </message>
    <message>
        <source>true: the block is cut and then left out: false when absent</source>
        <translation>wahr: der Block wird geschnitten und dann ausgelassen: falsch, wenn es fehlt</translation>
    </message>
    <message>
        <source>an object with at and with, points inside two blocks that share a face</source>
        <translation>ein Objekt mit at und with, Punkten in zwei Blöcken, die eine Fläche teilen</translation>
    </message>
    <message>
        <source>The block at</source>
        <translation>Der Block bei</translation>
    </message>
    <message>
        <source>With the one at</source>
        <translation>Mit dem bei</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>Innerhalb</translation>
    </message>
    <message>
        <source>distance within which the size holds, m; over one more it grows to the blocks&apos; own</source>
        <translation>Entfernung, in der die Weite gilt, m; über eine weitere wächst sie auf die der Blöcke</translation>
    </message>
    <message>
        <source>edge length of the tetrahedra there, m</source>
        <translation>Kantenlänge der Tetraeder dort, m</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Grenzfläche</translation>
    </message>
    <message>
        <source>an object with between and joint</source>
        <translation>ein Objekt mit between und joint</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Zwischen</translation>
    </message>
    <message>
        <source>names of the two blocks</source>
        <translation>Namen der beiden Blöcke</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>an object with block, displacement or table, and at unless a fixed block is moved as a whole</source>
        <translation>ein Objekt mit block, displacement oder table, und at, wenn nicht ein fester Block als Ganzes bewegt wird</translation>
    </message>
    <message>
        <source>the point that is held, m: the whole block, which must be fixed, when absent</source>
        <translation>der festgehaltene Punkt, m: der ganze Block, der fest sein muss, wenn er fehlt</translation>
    </message>
    <message>
        <source>the whole block</source>
        <translation>der ganze Block</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>[x, y, z], m; null leaves a component free</source>
        <translation>[x, y, z], m; null lässt eine Komponente frei</translation>
    </message>
    <message>
        <source>displacement, m, or null for free</source>
        <translation>Verschiebung, m, oder null für frei</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>By time</source>
        <translation>Nach Zeit</translation>
    </message>
    <message>
        <source>displacement by time: rows [t, x, y, z], s and m; null in every row leaves a component free</source>
        <translation>Verschiebung nach Zeit: Zeilen [t, x, y, z], s und m; null in jeder Zeile lässt eine Komponente frei</translation>
    </message>
    <message>
        <source>a row [t, x, y, z]: time, s, and displacement, m</source>
        <translation>eine Zeile [t, x, y, z]: Zeit, s, und Verschiebung, m</translation>
    </message>
    <message>
        <source>time, s, or displacement, m, or null for free</source>
        <translation>Zeit, s, oder Verschiebung, m, oder null für frei</translation>
    </message>
    <message>
        <source>Point load</source>
        <translation>Punktlast</translation>
    </message>
    <message>
        <source>an object with block, at, and force or table</source>
        <translation>ein Objekt mit block, at, und force oder table</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Unveränderlich</translation>
    </message>
    <message>
        <source>force [x, y, z], N</source>
        <translation>Kraft [x, y, z], N</translation>
    </message>
    <message>
        <source>force by time: rows [t, x, y, z], s and N</source>
        <translation>Kraft nach Zeit: Zeilen [t, x, y, z], s und N</translation>
    </message>
    <message>
        <source>a row [t, x, y, z]: time, s, and force, N</source>
        <translation>eine Zeile [t, x, y, z]: Zeit, s, und Kraft, N</translation>
    </message>
    <message>
        <source>time, s, or force, N</source>
        <translation>Zeit, s, oder Kraft, N</translation>
    </message>
    <message>
        <source>Initial velocity</source>
        <translation>Anfangsgeschwindigkeit</translation>
    </message>
    <message>
        <source>an object with block, and linear or angular</source>
        <translation>ein Objekt mit block, und linear oder angular</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>velocity of the centroid, m/s: zero when absent</source>
        <translation>Geschwindigkeit des Schwerpunkts, m/s: null, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>rotation about the centroid, rad/s: zero when absent</source>
        <translation>Drehung um den Schwerpunkt, rad/s: null, wenn sie fehlt</translation>
    </message>
    <message>
        <source>an object with stress, and where it is wanted gradient, level and blocks</source>
        <translation>ein Objekt mit stress, und wo gewünscht gradient, level und blocks</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>names of the blocks that bear it: all when absent</source>
        <translation>Namen der Blöcke, die sie tragen: alle, wenn es fehlt</translation>
    </message>
    <message>
        <source>every block</source>
        <translation>alle Blöcke</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>stress at the level, [xx, yy, zz, xy, yz, zx], Pa, tension positive</source>
        <translation>Spannung in der Bezugshöhe, [xx, yy, zz, xy, yz, zx], Pa, Zug positiv</translation>
    </message>
    <message>
        <source>Per metre up</source>
        <translation>Je Meter aufwärts</translation>
    </message>
    <message>
        <source>stress per metre upwards, Pa/m: zero when absent</source>
        <translation>Spannung je Meter aufwärts, Pa/m: null, wenn sie fehlt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Level z</source>
        <translation>Bezugshöhe z</translation>
    </message>
    <message>
        <source>height z at which the stress is as given, m: 0 when absent</source>
        <translation>Höhe z, in der die Spannung wie angegeben ist, m: 0, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Joint strength</source>
        <translation>Kluftfestigkeit</translation>
    </message>
    <message>
        <source>an object with the strength that changes; the rest stays as it was</source>
        <translation>ein Objekt mit der Festigkeit, die sich ändert; der Rest bleibt, wie er war</translation>
    </message>
    <message>
        <source>as before</source>
        <translation>wie zuvor</translation>
    </message>
    <message>
        <source>cohesion, Pa</source>
        <translation>Kohäsion, Pa</translation>
    </message>
    <message>
        <source>tensile strength, Pa</source>
        <translation>Zugfestigkeit, Pa</translation>
    </message>
    <message>
        <source>friction angle once cohesion is broken, degrees</source>
        <translation>Reibungswinkel, wenn die Kohäsion gebrochen ist, Grad</translation>
    </message>
    <message>
        <source>Block held or let go</source>
        <translation>Block halten, loslassen</translation>
    </message>
    <message>
        <source>an object with name and body: fixed holds the block, the body that it was built as lets it go</source>
        <translation>ein Objekt mit name und body: fest hält den Block, das Verhalten, mit dem er gebaut wurde, lässt ihn los</translation>
    </message>
    <message>
        <source>fixed, or the body that the block was built as, auto where that was asked for</source>
        <translation>fest, oder das Verhalten, mit dem der Block gebaut wurde, automatisch, wo das verlangt war</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>an object with name, type, time_step, and steps or duration</source>
        <translation>ein Objekt mit name, type, time_step, und steps oder duration</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>static (velocities start from zero in each step) or dynamic</source>
        <translation>statisch (Geschwindigkeiten beginnen in jedem Schritt bei null) oder dynamisch</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>time step, s</source>
        <translation>Zeitschritt, s</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>number of time steps</source>
        <translation>Anzahl der Zeitschritte</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>model time of the stage, s</source>
        <translation>Modellzeit des Abschnitts, s</translation>
    </message>
    <message>
        <source>Until equilibrium</source>
        <translation>Bis Gleichgewicht</translation>
    </message>
    <message>
        <source>true: a static stage ends as soon as nothing moves any more; steps or duration is then the most it may take</source>
        <translation>wahr: ein statischer Abschnitt endet, sobald sich nichts mehr bewegt; Schritte oder Dauer ist dann das Höchste, was er nehmen darf</translation>
    </message>
    <message>
        <source>unbalanced force over the largest force at which the stage is in equilibrium: 1e-5 when absent</source>
        <translation>Ungleichgewicht, bezogen auf die größte Kraft, bei dem der Abschnitt im Gleichgewicht ist: 1e-5, wenn es fehlt</translation>
    </message>
    <message>
        <source>damping of all masses in this stage, 1/s: none when absent</source>
        <translation>Dämpfung aller Massen in diesem Abschnitt, 1/s: keine, wenn sie fehlt</translation>
    </message>
    <message>
        <source>joint strength that changes with the stage, by the joint&apos;s name</source>
        <translation>Kluftfestigkeit, die sich mit dem Abschnitt ändert, nach dem Namen der Kluft</translation>
    </message>
    <message>
        <source>point loads in place of those before: those before when absent</source>
        <translation>Punktlasten anstelle derer zuvor: die zuvor, wenn sie fehlen</translation>
    </message>
    <message>
        <source>constraints in place of those before: those before when absent</source>
        <translation>Lager anstelle derer zuvor: die zuvor, wenn sie fehlen</translation>
    </message>
    <message>
        <source>Held or let go</source>
        <translation>Halten, loslassen</translation>
    </message>
    <message>
        <source>blocks that are held or let go from this stage on</source>
        <translation>Blöcke, die von diesem Abschnitt an gehalten oder losgelassen werden</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>how it is solved</source>
        <translation>wie gelöst wird</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>corotational (when absent), or incremental, the paper&apos;s own</source>
        <translation>korotational (wenn es fehlt), oder inkrementell, wie in der Veröffentlichung</translation>
    </message>
    <message>
        <source>Integrator</source>
        <translation>Zeitintegration</translation>
    </message>
    <message>
        <source>newmark (when absent), constant-acceleration, the paper&apos;s own, or generalized-alpha</source>
        <translation>Newmark (wenn es fehlt), konstante Beschleunigung, wie in der Veröffentlichung, oder Generalized-α</translation>
    </message>
    <message>
        <source>Spectral radius</source>
        <translation>Spektralradius</translation>
    </message>
    <message>
        <source>of generalized-alpha at infinite frequency, 0 (damps most) to 1 (damps nothing): 0.8 when absent</source>
        <translation>von Generalized-α bei unendlicher Frequenz, 0 (dämpft am meisten) bis 1 (dämpft nicht): 0.8, wenn er fehlt</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>area (when absent) where facets face each other, or facet-wise, the paper&apos;s fast common plane</source>
        <translation>Fläche (wenn es fehlt), wo Facetten einander gegenüberliegen, oder facettenweise, die schnelle gemeinsame Ebene der Veröffentlichung</translation>
    </message>
    <message>
        <source>Contact stiffness</source>
        <translation>Kontaktsteifigkeit</translation>
    </message>
    <message>
        <source>normal stiffness of contacts in units of E/h, no unit: 10 when absent</source>
        <translation>Normalsteifigkeit der Kontakte in Einheiten von E/h, ohne Einheit: 10, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Penetration</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>penetration over mesh size that contacts are held to: when absent springs as they are in static stages, and in dynamic ones such as give by 2.5e-4, or by the tolerance if that is more</source>
        <translation>Eindringung, bezogen auf die Netzweite, an die Kontakte gehalten werden: wenn sie fehlt, Federn, wie sie sind, in statischen Abschnitten, in dynamischen solche, die um 2,5e-4 nachgeben, oder um die Toleranz, wenn diese größer ist</translation>
    </message>
    <message>
        <source>by the stage</source>
        <translation>nach dem Abschnitt</translation>
    </message>
    <message>
        <source>by the tolerance</source>
        <translation>nach der Toleranz</translation>
    </message>
    <message>
        <source>Open–close limit</source>
        <translation>Open–close-Grenze</translation>
    </message>
    <message>
        <source>open–close iterations after which the step is cut: 160 when absent</source>
        <translation>Open–close-Iterationen, nach denen der Schritt gekürzt wird: 160, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Sleep below</source>
        <translation>Ruht unter</translation>
    </message>
    <message>
        <source>speed in mesh sizes a second below which a block at rest sleeps in dynamic stages: when absent the tolerance, 1e-9 to 1e-5; 0: none sleeps</source>
        <translation>Geschwindigkeit in Netzweiten je Sekunde, unter der ein Block in Ruhe in dynamischen Abschnitten nicht gerechnet wird: wenn sie fehlt, die Toleranz, 1e-9 bis 1e-5; 0: keiner ruht</translation>
    </message>
    <message>
        <source>Time steps</source>
        <translation>Zeitschritte</translation>
    </message>
    <message>
        <source>fixed (when absent): steps as long as the stage says, or adaptive: as long as the limits under adaptive allow</source>
        <translation>fest (wenn es fehlt): Schritte, so lang der Abschnitt sagt, oder angepasst: so lang die Grenzen darunter erlauben</translation>
    </message>
    <message>
        <source>Adaptive steps</source>
        <translation>Angepasste Schritte</translation>
    </message>
    <message>
        <source>what adaptive steps keep to</source>
        <translation>woran angepasste Schritte sich halten</translation>
    </message>
    <message>
        <source>usual limits</source>
        <translation>übliche Grenzen</translation>
    </message>
    <message>
        <source>largest displacement in a step, of half the model&apos;s height: 0.005 when absent</source>
        <translation>größte Verschiebung in einem Schritt, der halben Höhe des Modells: 0.005, wenn sie fehlt</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>error of time integration in a step, of the smallest mesh size: 1e-4 when absent</source>
        <translation>Fehler der Zeitintegration in einem Schritt, der kleinsten Netzweite: 1e-4, wenn er fehlt</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>open–close iterations above which the next step is shorter: 8 when absent</source>
        <translation>Open–close-Iterationen, über denen der nächste Schritt kürzer wird: 8, wenn sie fehlen</translation>
    </message>
    <message>
        <source>Shortest</source>
        <translation>Kürzester</translation>
    </message>
    <message>
        <source>shortest step, of the stage&apos;s time_step: 1e-3 when absent</source>
        <translation>kürzester Schritt, des Zeitschritts des Abschnitts: 1e-3, wenn er fehlt</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>an object with name, block and at</source>
        <translation>ein Objekt mit name, block und at</translation>
    </message>
    <message>
        <source>Record stress</source>
        <translation>Spannung messen</translation>
    </message>
    <message>
        <source>true: the stress at the point is recorded too: false when absent</source>
        <translation>wahr: auch die Spannung am Punkt wird aufgezeichnet: falsch, wenn es fehlt</translation>
    </message>
    <message>
        <source>Expected value</source>
        <translation>Erwarteter Wert</translation>
    </message>
    <message>
        <source>an object with quantity, time, value, tolerance and source</source>
        <translation>ein Objekt mit quantity, time, value, tolerance und source</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>NAME.displacement.z or NAME.velocity.magnitude, NAME a monitor, or a block for its centroid; NAME.stress.zz of a monitor that records stress</source>
        <translation>NAME.displacement.z oder NAME.velocity.magnitude, NAME ein Messpunkt, oder ein Block für seinen Schwerpunkt; NAME.stress.zz eines Messpunkts, der Spannung aufzeichnet</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>model time, s</source>
        <translation>Modellzeit, s</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>m, m/s or Pa</source>
        <translation>m, m/s oder Pa</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>model time, s, since which the change is counted (creep after settling): the start when absent</source>
        <translation>Modellzeit, s, seit der die Änderung gezählt wird (Kriechen nach dem Setzen): der Anfang, wenn sie fehlt</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>dem Anfang</translation>
    </message>
    <message>
        <source>relative to |value|; absolute (m, m/s or Pa) where the value is 0</source>
        <translation>bezogen auf |Wert|; absolut (m, m/s oder Pa), wo der Wert 0 ist</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>where the value comes from</source>
        <translation>woher der Wert kommt</translation>
    </message>
    <message>
        <source>force that a step leaves out of balance on a block, over the largest force on it: draft (1e-3), standard (1e-6, when absent), reference (1e-10), or a number from 1e-12 to 0.01</source>
        <translation>Kraft, die ein Schritt an einem Block unausgeglichen lässt, bezogen auf die größte Kraft an ihm: grob (1e-3), üblich (1e-6, wenn nichts dasteht), fein (1e-10) oder eine Zahl von 1e-12 bis 0,01</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>what the settings are that a project leaves out: talus (when absent), or paper, the paper&apos;s own scheme as a whole</source>
        <translation>was gilt, wo das Projekt nichts sagt: Talus (wenn nichts dasteht) oder Aufsatz, das Verfahren des Aufsatzes als Ganzes</translation>
    </message>
    <message>
        <source>Open–close</source>
        <translation>Öffnen–Schließen</translation>
    </message>
    <message>
        <source>newton (when absent), or states, the paper&apos;s own: rounds in which contacts keep their states</source>
        <translation>Newton (wenn nichts dasteht) oder Zustände, wie im Aufsatz: Runden, in denen Kontakte ihren Zustand behalten</translation>
    </message>
    <message>
        <source>Static inertia</source>
        <translation>Statische Trägheit</translation>
    </message>
    <message>
        <source>inertia of static steps: fading with what is out of balance (when absent), or full, the paper&apos;s own</source>
        <translation>Trägheit statischer Schritte: schwindend mit dem, was unausgeglichen ist (wenn nichts dasteht), oder volle, wie im Aufsatz</translation>
    </message>
    <message>
        <source>Beyond the equations</source>
        <translation>Über die Gleichungen hinaus</translation>
    </message>
    <message>
        <source>impacts, sleep, updated normals and whatever else is beyond the equations: as called_for by the scene (when absent), or none, as in the paper</source>
        <translation>Stöße, Schlaf, nachgeführte Normalen und was sonst über die Gleichungen hinausgeht: was die Szene verlangt (wenn nichts dasteht) oder keine, wie im Aufsatz</translation>
    </message>
    <message>
        <source>On and off</source>
        <translation>An und aus</translation>
    </message>
    <message>
        <source>what costs and can be left out, each as called_for by the scene, on or off</source>
        <translation>was kostet und wegbleiben kann, jedes, wie die Szene es verlangt, an oder aus</translation>
    </message>
    <message>
        <source>as called for</source>
        <translation>was die Szene verlangt</translation>
    </message>
    <message>
        <source>Contact of blocks</source>
        <translation>Kontakt der Blöcke</translation>
    </message>
    <message>
        <source>blocks touch, where some can come near another within the run (called_for, when absent); off: they pass through each other</source>
        <translation>Blöcke berühren sich, wo im Lauf einer in die Nähe eines anderen kommen kann (wie verlangt, wenn nichts dasteht); aus: sie gehen durcheinander hindurch</translation>
    </message>
    <message>
        <source>Impacts</source>
        <translation>Stöße</translation>
    </message>
    <message>
        <source>the law of impact, where a restitution is given or a rigid block may be stopped (called_for, when absent)</source>
        <translation>das Stoßgesetz, wo eine Rückprallzahl angegeben ist oder ein starrer Block aufgehalten werden kann (wie verlangt, wenn nichts dasteht)</translation>
    </message>
    <message>
        <source>that joints give, in the law of impact, where one does (called_for, when absent); off: as if none did</source>
        <translation>die der Klüfte im Stoßgesetz, wo eine angegeben ist (wie verlangt, wenn nichts dasteht); aus: als gäbe es keine</translation>
    </message>
    <message>
        <source>Detection along the way</source>
        <translation>Suche unterwegs</translation>
    </message>
    <message>
        <source>a step in which blocks turn into each other unforeseen takes these contacts in, in dynamic stages (called_for, when absent)</source>
        <translation>ein Schritt, in dem Blöcke sich unvorhergesehen ineinander drehen, nimmt diese Kontakte auf, in dynamischen Abschnitten (wie verlangt, wenn nichts dasteht)</translation>
    </message>
    <message>
        <source>Updated normals</source>
        <translation>Nachgeführte Normalen</translation>
    </message>
    <message>
        <source>a contact that goes too deep as blocks turn gets the normal that it comes to, in dynamic stages (called_for, when absent)</source>
        <translation>ein Kontakt, der beim Drehen der Blöcke zu tief geht, bekommt die Normale, zu der er kommt, in dynamischen Abschnitten (wie verlangt, wenn nichts dasteht)</translation>
    </message>
    <message>
        <source>Penalty scaling</source>
        <translation>Versteifung der Kontakte</translation>
    </message>
    <message>
        <source>a contact that goes too deep gets a stiffer spring, in dynamic stages (called_for, when absent)</source>
        <translation>ein Kontakt, der zu tief geht, bekommt eine steifere Feder, in dynamischen Abschnitten (wie verlangt, wenn nichts dasteht)</translation>
    </message>
    <message>
        <source>Followed springs</source>
        <translation>Mitkommende Federn</translation>
    </message>
    <message>
        <source>new contacts of rigid and affine blocks are no stiffer than a step can follow, in dynamic stages (called_for, when absent)</source>
        <translation>neue Kontakte starrer und affiner Blöcke sind nicht steifer, als ein Schritt ihnen folgen kann, in dynamischen Abschnitten (wie verlangt, wenn nichts dasteht)</translation>
    </message>
    <message>
        <source>Acceleration reset</source>
        <translation>Rücksetzen der Beschleunigung</translation>
    </message>
    <message>
        <source>a block that was struck does not go on with the acceleration of the blow, in dynamic stages (called_for, when absent)</source>
        <translation>ein gestoßener Block behält die Beschleunigung des Stoßes nicht bei, in dynamischen Abschnitten (wie verlangt, wenn nichts dasteht)</translation>
    </message>
    <message>
        <source>Sleep</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>blocks at rest cost nothing, in dynamic stages (called_for, when absent)</source>
        <translation>ruhende Blöcke kosten nichts, in dynamischen Abschnitten (wie verlangt, wenn nichts dasteht)</translation>
    </message>
    <message>
        <source>Balanced alone</source>
        <translation>Allein ins Gleichgewicht</translation>
    </message>
    <message>
        <source>rigid and affine blocks that are far out of balance are balanced by themselves (called_for, when absent)</source>
        <translation>starre und affine Blöcke, die weit aus dem Gleichgewicht sind, kommen für sich allein ins Gleichgewicht (wie verlangt, wenn nichts dasteht)</translation>
    </message>
    <message>
        <source>called_for by the scene (when absent), on or off</source>
        <translation>wie die Szene es verlangt (wenn nichts dasteht), an oder aus</translation>
    </message>
    <message>
        <source>Near points and faces</source>
        <translation>Nahe Punkten und Flächen</translation>
    </message>
    <message>
        <source>points and faces around which the mesh is finer or coarser</source>
        <translation>Punkte und Flächen, um die das Netz feiner oder gröber ist</translation>
    </message>
    <message>
        <source>Mesh near a place</source>
        <translation>Netz bei einer Stelle</translation>
    </message>
    <message>
        <source>an object with at or face, radius and size</source>
        <translation>ein Objekt mit at oder face, radius und size</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nahe</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>a flat face: corners [x, y, z] in order, m</source>
        <translation>eine ebene Fläche: Ecken [x, y, z] der Reihe nach, m</translation>
    </message>
    <message>
        <source>Tetrahedra at most</source>
        <translation>Tetraeder höchstens</translation>
    </message>
    <message>
        <source>what becomes of thin or tiny pieces that the cuts leave</source>
        <translation>was aus dünnen oder winzigen Stücken wird, die die Schnitte lassen</translation>
    </message>
    <message>
        <source>Chip volume, of the median</source>
        <translation>Volumen von Krümeln, vom Median</translation>
    </message>
    <message>
        <source>a block of less than this share of the median volume of its solid&apos;s blocks is a splinter, too, unless blocks names it: 1e-6 when absent, 0: none is</source>
        <translation>auch ein Block, dessen Volumen kleiner ist als dieser Anteil am Median der Blöcke seines Körpers, ist ein Splitter, wenn blocks ihn nicht nennt: 1e-6, wenn es fehlt, 0: keiner</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Festigkeit</translation>
    </message>
    <message>
        <source>of whole rock by Mohr and Coulomb, an object with cohesion and friction_angle: results are measured against it, no run uses it</source>
        <translation>des ganzen Gesteins nach Mohr und Coulomb, ein Objekt mit cohesion und friction_angle: Ergebnisse werden daran gemessen, keine Rechnung verwendet sie</translation>
    </message>
    <message>
        <source>cohesion, Pa (hard rock 5e6 to 30e6)</source>
        <translation>Kohäsion, Pa (hartes Gestein 5e6 bis 30e6)</translation>
    </message>
    <message>
        <source>friction angle, degrees (hard rock 40 to 55)</source>
        <translation>Reibungswinkel, Grad (hartes Gestein 40 bis 55)</translation>
    </message>
    <message>
        <source>where tension is cut off, Pa: at the apex, cohesion / tan(friction angle), when absent, and no more than that</source>
        <translation>wo der Zug gekappt wird, Pa: an der Spitze, Kohäsion / tan(Reibungswinkel), wenn nichts angegeben ist, und höchstens dort</translation>
    </message>
    <message>
        <source>c / tan φ</source>
        <translation>c / tan φ</translation>
    </message>
</context>
<context>
    <name>talus::AccuracyChart</name>
    <message>
        <source>Error against processor time of the runs</source>
        <translation>Fehler über der Rechenzeit der Läufe</translation>
    </message>
    <message>
        <source>Run %1: %2
%3 s, error %4</source>
        <translation>Lauf %1: %2
%3 s, Fehler %4</translation>
    </message>
    <message>
        <source>Processor time of solving, s</source>
        <translation>Rechenzeit, s</translation>
    </message>
    <message>
        <source>Error, relative</source>
        <translation>Fehler, bezogen</translation>
    </message>
    <message>
        <source>best for its cost</source>
        <translation>bester für seinen Aufwand</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>others</source>
        <translation>andere</translation>
    </message>
</context>
<context>
    <name>talus::AccuracyPanel</name>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Another study&apos;s accuracy.json</source>
        <translation>Die accuracy.json einer anderen Untersuchung</translation>
    </message>
    <message>
        <source>Runs of the study</source>
        <translation>Läufe der Untersuchung</translation>
    </message>
    <message>
        <source>What is good enough</source>
        <translation>Was gut genug ist</translation>
    </message>
    <message>
        <source>Error of at most</source>
        <translation>Fehler höchstens</translation>
    </message>
    <message>
        <source>1 %</source>
        <translation>1 %</translation>
    </message>
    <message>
        <source>Chosen run</source>
        <translation>Gewählter Lauf</translation>
    </message>
    <message>
        <source>Use this setting</source>
        <translation>Diese Einstellung nehmen</translation>
    </message>
    <message>
        <source>Orders of convergence</source>
        <translation>Konvergenzordnungen</translation>
    </message>
    <message>
        <source>Open an accuracy study</source>
        <translation>Eine Genauigkeitsuntersuchung öffnen</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Untersuchungen (*.json)</translation>
    </message>
    <message>
        <source>There is no study of this project</source>
        <translation>Zu diesem Projekt gibt es keine Untersuchung</translation>
    </message>
    <message>
        <source>%1: what accuracy costs</source>
        <translation>%1: was Genauigkeit kostet</translation>
    </message>
    <message>
        <source>%1, errors from %2</source>
        <translation>%1, Fehler von %2 an</translation>
    </message>
    <message>
        <source>best</source>
        <translation>bester</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>For its cost</source>
        <translation>Für den Aufwand</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>CPU s</source>
        <translation>CPU s</translation>
    </message>
    <message>
        <source>Unknowns</source>
        <translation>Unbekannte</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Runs are</source>
        <translation>Läufe sind</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Theory</source>
        <translation>Theorie</translation>
    </message>
    <message>
        <source>Finest off by</source>
        <translation>Feinster daneben um</translation>
    </message>
    <message>
        <source>Type an error to meet, and the cheapest run that does is chosen.</source>
        <translation>Einen Fehler eingeben, der einzuhalten ist: der billigste Lauf, der es tut, wird gewählt.</translation>
    </message>
    <message>
        <source>No run of this study is within %1.</source>
        <translation>Kein Lauf dieser Untersuchung liegt innerhalb von %1.</translation>
    </message>
    <message>
        <source>Run %1 is the cheapest within %2.</source>
        <translation>Lauf %1 ist der billigste innerhalb von %2.</translation>
    </message>
    <message>
        <source>Run %1: %2
%3 s, error %4</source>
        <translation>Lauf %1: %2
%3 s, Fehler %4</translation>
    </message>
    <message>
        <source>A run goes on</source>
        <translation>Ein Lauf ist im Gange</translation>
    </message>
    <message>
        <source>The study came without its project</source>
        <translation>Die Untersuchung kam ohne ihr Projekt</translation>
    </message>
    <message>
        <source>The study is of another project, or of this one before it was changed</source>
        <translation>Die Untersuchung gehört zu einem anderen Projekt oder zu diesem, bevor es geändert wurde</translation>
    </message>
    <message>
        <source>The project has this setting</source>
        <translation>Das Projekt hat diese Einstellung</translation>
    </message>
    <message>
        <source>Open… shows another one; talus-cli study accuracy PROJECT makes one, too</source>
        <translation>Öffnen… zeigt eine andere; auch talus-cli study accuracy PROJEKT macht eine</translation>
    </message>
    <message>
        <source>The study</source>
        <translation>Die Studie</translation>
    </message>
</context>
<context>
    <name>talus::AccuracySlider</name>
    <message>
        <source>Use</source>
        <translation>Nehmen</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>grob</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>fein</translation>
    </message>
    <message>
        <source>From the cheapest setting to the most accurate one</source>
        <translation>Von der billigsten Einstellung zur genauesten</translation>
    </message>
    <message>
        <source>%1, error %2</source>
        <translation>%1, Fehler %2</translation>
    </message>
    <message>
        <source>: as the project is now</source>
        <translation>: wie das Projekt jetzt ist</translation>
    </message>
</context>
<context>
    <name>talus::BlockActions</name>
    <message>
        <source>Select by rule…</source>
        <translation>Nach Regel wählen…</translation>
    </message>
    <message>
        <source>Ctrl+F</source>
        <translation>Ctrl+F</translation>
    </message>
    <message>
        <source>Select all blocks</source>
        <translation>Alle Blöcke wählen</translation>
    </message>
    <message>
        <source>Ctrl+A</source>
        <translation>Ctrl+A</translation>
    </message>
    <message>
        <source>Select the other blocks</source>
        <translation>Die anderen Blöcke wählen</translation>
    </message>
    <message>
        <source>Ctrl+I</source>
        <translation>Ctrl+I</translation>
    </message>
    <message>
        <source>Select neighbours, too</source>
        <translation>Auch Nachbarn wählen</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>Shift and drag draw a lasso</source>
        <translation>Umschalt und Ziehen zeichnen ein Lasso</translation>
    </message>
    <message>
        <source>Excavate selected blocks</source>
        <translation>Gewählte Blöcke ausbrechen</translation>
    </message>
    <message>
        <source>Merge selected blocks</source>
        <translation>Gewählte Blöcke zusammenfassen</translation>
    </message>
    <message>
        <source>There are no blocks yet</source>
        <translation>Es gibt noch keine Blöcke</translation>
    </message>
    <message>
        <source>Select two blocks or more</source>
        <translation>Zwei Blöcke oder mehr wählen</translation>
    </message>
    <message>
        <source>Select a block first</source>
        <translation>Zuerst einen Block wählen</translation>
    </message>
    <message>
        <source>Their neighbours are looked for on the page Blocks</source>
        <translation>Ihre Nachbarn werden auf der Seite Blöcke gesucht</translation>
    </message>
</context>
<context>
    <name>talus::BlockHistoryPanel</name>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern …</translation>
    </message>
    <message>
        <source>Quantity of the left plot</source>
        <translation>Größe des linken Diagramms</translation>
    </message>
    <message>
        <source>Quantity of the right plot</source>
        <translation>Größe des rechten Diagramms</translation>
    </message>
    <message>
        <source>What of the blocks that are selected is shown over time</source>
        <translation>Was von den gewählten Blöcken über die Zeit gezeigt wird</translation>
    </message>
    <message>
        <source>Histories of blocks are shown when a run has ended.</source>
        <translation>Verläufe von Blöcken werden gezeigt, wenn ein Lauf zu Ende ist.</translation>
    </message>
    <message>
        <source>Click a block in the view or the table to see what became of it; Ctrl and a click adds another.</source>
        <translation>Einen Block in der Ansicht oder der Tabelle anklicken, um zu sehen, was aus ihm wurde; Strg und ein Klick nimmt einen weiteren hinzu.</translation>
    </message>
    <message>
        <source>The frames are being read.</source>
        <translation>Die Bilder werden gelesen.</translation>
    </message>
    <message>
        <source>Save the histories of the selected blocks</source>
        <translation>Verläufe der gewählten Blöcke speichern</translation>
    </message>
</context>
<context>
    <name>talus::BlockViewTools</name>
    <message>
        <source>Colour by</source>
        <translation>Farbe nach</translation>
    </message>
    <message>
        <source>What the blocks are coloured by</source>
        <translation>Wonach die Blöcke gefärbt sind</translation>
    </message>
    <message>
        <source>How far blocks are drawn apart</source>
        <translation>Wie weit Blöcke auseinander gezeichnet werden</translation>
    </message>
    <message>
        <source>How far blocks are drawn apart (E)</source>
        <translation>Wie weit Blöcke auseinander gezeichnet werden (E)</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Auseinander</translation>
    </message>
</context>
<context>
    <name>talus::BlocksPanel</name>
    <message>
        <source>Look for blocks</source>
        <translation>Blöcke suchen</translation>
    </message>
    <message>
        <source>Shows the rows that have these letters in one of their words</source>
        <translation>Zeigt die Zeilen, in denen ein Wort diese Buchstaben hat</translation>
    </message>
    <message>
        <source>Blocks that are left out; each can be brought back</source>
        <translation>Blöcke, die ausgelassen sind; jeder kann zurückgeholt werden</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Blocks, before the last change</source>
        <translation>Blöcke, vor der letzten Änderung</translation>
    </message>
    <message>
        <source>Not cut yet.</source>
        <translation>Noch nicht geschnitten.</translation>
    </message>
    <message>
        <source>No block was left.</source>
        <translation>Kein Block blieb übrig.</translation>
    </message>
    <message>
        <source>No block is like this.</source>
        <translation>Kein Block ist so.</translation>
    </message>
    <message>
        <source>%1 excavated</source>
        <translation>%1 ausgebrochen</translation>
    </message>
    <message>
        <source>Bring all back</source>
        <translation>Alle zurückholen</translation>
    </message>
    <message>
        <source>Bring back %1</source>
        <translation>%1 zurückholen</translation>
    </message>
</context>
<context>
    <name>talus::BottomPanel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Histories</source>
        <translation>Verläufe</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Problems  %1</source>
        <translation>Probleme  %1</translation>
    </message>
    <message>
        <source>Splinters  %1</source>
        <translation>Splitter  %1</translation>
    </message>
    <message>
        <source>Run-out</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Blocks&apos; histories</source>
        <translation>Verläufe der Blöcke</translation>
    </message>
    <message>
        <source>Along a line</source>
        <translation>Entlang einer Linie</translation>
    </message>
    <message>
        <source>Joints that slipped</source>
        <translation>Geglittene Klüfte</translation>
    </message>
</context>
<context>
    <name>talus::CasePage</name>
    <message>
        <source>not run yet</source>
        <translation>noch nicht gerechnet</translation>
    </message>
    <message>
        <source>passed in %1</source>
        <translation>bestanden in %1</translation>
    </message>
    <message>
        <source>failed in %1</source>
        <translation>gescheitert in %1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>Came to no answer: %1</source>
        <translation>Kam zu keiner Antwort: %1</translation>
    </message>
    <message>
        <source>This case takes minutes.</source>
        <translation>Dieser Fall dauert Minuten.</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Computed</source>
        <translation>Gerechnet</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Error and tolerance are relative to the expected number; with ± they are in its unit.</source>
        <translation>Fehler und Toleranz sind auf die erwartete Zahl bezogen; mit ± stehen sie in ihrer Einheit.</translation>
    </message>
</context>
<context>
    <name>talus::ChoiceField</name>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
</context>
<context>
    <name>talus::CommandSearch</name>
    <message>
        <source>Find a command   Ctrl+K</source>
        <translation>Befehl suchen   Strg+K</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Any command of the menus and buttons, by some letters of its name (Ctrl+K)</source>
        <translation>Jeder Befehl der Menüs und Knöpfe, nach einigen Buchstaben seines Namens (Strg+K)</translation>
    </message>
</context>
<context>
    <name>talus::ComparedViewport</name>
    <message>
        <source>End comparing</source>
        <translation>Vergleich beenden</translation>
    </message>
    <message>
        <source>The results that are compared</source>
        <translation>Die verglichenen Ergebnisse</translation>
    </message>
    <message>
        <source>Draw its blocks&apos; edges over the view beside it</source>
        <translation>Kanten seiner Blöcke über die Ansicht daneben zeichnen</translation>
    </message>
</context>
<context>
    <name>talus::CostAhead</name>
    <message>
        <source>This run cannot be estimated: %1.</source>
        <translation>Dieser Lauf lässt sich nicht schätzen: %1.</translation>
    </message>
    <message>
        <source>What this run will cost is said here once its blocks are cut and meshed.</source>
        <translation>Was dieser Lauf kosten wird, steht hier, sobald die Blöcke geschnitten und vernetzt sind.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>This run: estimating…</source>
        <translation>Dieser Lauf: wird geschätzt…</translation>
    </message>
    <message>
        <source>This run will not converge; it ends after about %1 of solving: %2</source>
        <translation>Dieser Lauf wird nicht konvergieren; er endet nach etwa %1 Rechnen: %2</translation>
    </message>
    <message>
        <source>This run: about %1, %2, error %3</source>
        <translation>Dieser Lauf: etwa %1, %2, Fehler %3</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Solving and writing on this machine, foreseen from the first steps of the run and from the whole of it in outline, with rigid blocks in long steps. The error is that of the project&apos;s accuracy study, or else what its time steps leave out (step doubling).</source>
        <translation>Rechnen und Schreiben auf diesem Rechner, vorausgesehen aus den ersten Schritten des Laufs und aus dem ganzen im Umriss, mit starren Blöcken in langen Schritten. Der Fehler ist der aus der Genauigkeitsuntersuchung des Projekts, oder sonst was seine Zeitschritte auslassen (Schrittverdopplung).</translation>
    </message>
    <message>
        <source>This run took %1, error %2</source>
        <translation>Dieser Lauf hat %1 gebraucht, Fehler %2</translation>
    </message>
</context>
<context>
    <name>talus::CurrentProject</name>
    <message>
        <source>saved %1</source>
        <translation>%1 gesichert</translation>
    </message>
    <message>
        <source>copied %1 beside the project</source>
        <translation>%1 neben das Projekt kopiert</translation>
    </message>
    <message>
        <source>add solid %1</source>
        <translation>Körper %1 hinzufügen</translation>
    </message>
    <message>
        <source>use %1</source>
        <translation>%1 nehmen</translation>
    </message>
    <message>
        <source>the project has the setting %1</source>
        <translation>das Projekt hat die Einstellung %1</translation>
    </message>
</context>
<context>
    <name>talus::CurrentRun</name>
    <message>
        <source>Open a project first</source>
        <translation>Zuerst ein Projekt öffnen</translation>
    </message>
    <message>
        <source>A run goes on</source>
        <translation>Ein Lauf ist im Gange</translation>
    </message>
    <message>
        <source>The project has no solid</source>
        <translation>Das Projekt hat keinen Körper</translation>
    </message>
    <message>
        <source>run started</source>
        <translation>Lauf begonnen</translation>
    </message>
    <message>
        <source>cutting and meshing</source>
        <translation>schneidet und vernetzt</translation>
    </message>
    <message>
        <source>%1 cut and meshed</source>
        <translation>%1 geschnitten und vernetzt</translation>
    </message>
    <message>
        <source>run finished</source>
        <translation>Lauf fertig</translation>
    </message>
    <message>
        <source>run finished, but %1</source>
        <translation>Lauf fertig, aber %1</translation>
    </message>
    <message>
        <source>run stopped; its results stay</source>
        <translation>Lauf angehalten; seine Ergebnisse bleiben</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>the run was not brought to its end</source>
        <translation>der Lauf kam nicht zu seinem Ende</translation>
    </message>
    <message>
        <source>run goes on from %1 s</source>
        <translation>Lauf geht weiter ab %1 s</translation>
    </message>
    <message>
        <source>The results are being exported</source>
        <translation>Die Ergebnisse werden gerade ausgegeben</translation>
    </message>
    <message>
        <source>A run goes on in the background</source>
        <translation>Ein Lauf geht im Hintergrund weiter</translation>
    </message>
    <message>
        <source>asked the run in the background to stop</source>
        <translation>der Lauf im Hintergrund soll anhalten</translation>
    </message>
    <message>
        <source>Another window makes this run</source>
        <translation>Ein anderes Fenster rechnet ihn</translation>
    </message>
    <message>
        <source>Nothing runs</source>
        <translation>Es läuft nichts</translation>
    </message>
    <message>
        <source>the run in the background has ended</source>
        <translation>der Lauf im Hintergrund ist zu Ende</translation>
    </message>
    <message>
        <source>the run goes on in the background</source>
        <translation>der Lauf geht im Hintergrund weiter</translation>
    </message>
</context>
<context>
    <name>talus::CurveEditor</name>
    <message>
        <source>Drag a point, double-click a curve to put one in, Delete takes it away.
Arrow keys choose a point, with Ctrl they move it.</source>
        <translation>Punkt ziehen; Doppelklick auf eine Kurve setzt einen ein, Entf nimmt ihn weg.
Pfeiltasten wählen einen Punkt, mit Strg verschieben sie ihn.</translation>
    </message>
    <message>
        <source>%1: %2 s, %3 %4</source>
        <translation>%1: %2 s, %3 %4</translation>
    </message>
</context>
<context>
    <name>talus::DisplayPanel</name>
    <message>
        <source>Display</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Farbe nach</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>all frames</source>
        <translation>alle Bilder</translation>
    </message>
    <message>
        <source>this frame</source>
        <translation>dieses Bild</translation>
    </message>
    <message>
        <source>Range of the legend</source>
        <translation>Bereich der Legende</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>true</source>
        <translation>wahr</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>Displacements are drawn this many times as large</source>
        <translation>Verschiebungen werden so vielmal vergrößert gezeichnet</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>block edges</source>
        <translation>Blockkanten</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Overlays</source>
        <translation>Einblendungen</translation>
    </message>
    <message>
        <source>Contact points</source>
        <translation>Kontaktpunkte</translation>
    </message>
    <message>
        <source>Open grey, stick blue, slip orange</source>
        <translation>Offen grau, haftend blau, gleitend orange</translation>
    </message>
    <message>
        <source>Convergence trouble</source>
        <translation>Konvergenzprobleme</translation>
    </message>
    <message>
        <source>Marks the contacts at which steps were cut or took many iterations</source>
        <translation>Zeichnet die Kontakte aus, an denen Schritte gekürzt wurden oder viele Iterationen brauchten</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Time stamp</source>
        <translation>Zeitangabe</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Lines along the edges of blocks, of all tetrahedra at the surface, or none</source>
        <translation>Linien entlang der Kanten der Blöcke, aller Tetraeder an der Oberfläche, oder keine</translation>
    </message>
    <message>
        <source>Which colour stands for which value</source>
        <translation>Welche Farbe für welchen Wert steht</translation>
    </message>
    <message>
        <source>Model time and stage of the frame in view</source>
        <translation>Modellzeit und Abschnitt des gezeigten Bildes</translation>
    </message>
    <message>
        <source>Where east, north and up are</source>
        <translation>Wo Ost, Nord und oben sind</translation>
    </message>
    <message>
        <source>A length at the depth of the middle of the view</source>
        <translation>Eine Länge in der Tiefe der Mitte der Ansicht</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>The legend spans the values of all frames, those of the one in view, or what is typed</source>
        <translation>Die Legende umfasst die Werte aller Bilder, die des gezeigten, oder was eingegeben wird</translation>
    </message>
    <message>
        <source>From, to</source>
        <translation>Von, bis</translation>
    </message>
    <message>
        <source>Only values</source>
        <translation>Nur Werte</translation>
    </message>
    <message>
        <source>Faces on which the field has other values are not drawn; their edges stay</source>
        <translation>Flächen, auf denen das Feld andere Werte hat, werden nicht gezeichnet; ihre Kanten bleiben</translation>
    </message>
    <message>
        <source>Values that are drawn</source>
        <translation>Werte, die gezeichnet werden</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Zwischen</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>contact force</source>
        <translation>Kontaktkraft</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeile</translation>
    </message>
    <message>
        <source>principal stress</source>
        <translation>Hauptspannung</translation>
    </message>
    <message>
        <source>How fast blocks go where, the forces by which each two push each other, or the principal stresses: heads point inwards where rock is pressed</source>
        <translation>Wie schnell Blöcke wohin gehen, die Kräfte, mit denen je zwei gegeneinander drücken, oder die Hauptspannungen: Spitzen zeigen nach innen, wo Fels gedrückt wird</translation>
    </message>
    <message>
        <source>selected blocks</source>
        <translation>ausgewählte Blöcke</translation>
    </message>
    <message>
        <source>all blocks</source>
        <translation>alle Blöcke</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Axes of rotation</source>
        <translation>Drehachsen</translation>
    </message>
    <message>
        <source>About which blocks turn in the frame in view, by the right hand</source>
        <translation>Um die sich Blöcke im gezeigten Bild drehen, nach der rechten Hand</translation>
    </message>
    <message>
        <source>The ways that blocks&apos; centres have gone up to the frame in view</source>
        <translation>Die Wege der Blockmitten bis zum Bild in der Ansicht</translation>
    </message>
</context>
<context>
    <name>talus::EffectList</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Which effects the scene calls for, and what each will cost, is listed here when its blocks are cut and meshed.</source>
        <translation>Welche Effekte die Szene braucht und was jeder kosten wird, steht hier, wenn ihre Blöcke geschnitten und vernetzt sind.</translation>
    </message>
    <message>
        <source>time spent</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>iteration, estimated</source>
        <translation>Iteration, geschätzt</translation>
    </message>
    <message>
        <source>Effects: %1 of %2 on</source>
        <translation>Effekte: %1 von %2 an</translation>
    </message>
</context>
<context>
    <name>talus::EventList</name>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Time s</source>
        <translation>Zeit s</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Ereignis</translation>
    </message>
</context>
<context>
    <name>talus::ExportStrip</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1, %2 more to write</source>
        <translation>%1, noch %2 zu schreiben</translation>
    </message>
    <message>
        <source>Share of what is written</source>
        <translation>Anteil dessen, was geschrieben ist</translation>
    </message>
</context>
<context>
    <name>talus::FieldChooser</name>
    <message>
        <source>Colour by</source>
        <translation>Farbe nach</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponente</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>What the blocks are coloured by</source>
        <translation>Wonach die Blöcke gefärbt sind</translation>
    </message>
    <message>
        <source>Component or measure</source>
        <translation>Komponente oder Maß</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Klüfte</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
</context>
<context>
    <name>talus::FilmDialog</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Block that is followed</source>
        <translation>Verfolgter Block</translation>
    </message>
    <message>
        <source>Turns about the rock by</source>
        <translation>Kreist um den Fels um</translation>
    </message>
    <message>
        <source>Goes along with</source>
        <translation>Geht mit</translation>
    </message>
    <message>
        <source>Goes from key to key</source>
        <translation>Fährt von Ort zu Ort</translation>
    </message>
    <message>
        <source>Save film…</source>
        <translation>Film speichern…</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>%1 pixels wide</source>
        <translation>%1 Pixel breit</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 je Sekunde</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>In the view&apos;s shape</source>
        <translation>In der Form der Ansicht</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>That of play, which the timeline chooses</source>
        <translation>Das Tempo des Abspielens, das die Zeitleiste wählt</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Once round from the first picture to the last, or as far as is said, anticlockwise from above</source>
        <translation>Einmal herum vom ersten bis zum letzten Bild, oder so weit wie angegeben, von oben gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Degrees that the camera turns by</source>
        <translation>Grad, um die die Kamera kreist</translation>
    </message>
    <message>
        <source>The block stays in the middle of the picture</source>
        <translation>Der Block bleibt in der Bildmitte</translation>
    </message>
    <message>
        <source>Smoothly through the places of the table; at each key&apos;s moment it is there</source>
        <translation>Sanft durch die Orte der Tabelle; zum Zeitpunkt jedes Ortes ist sie dort</translation>
    </message>
    <message>
        <source>Camera keys</source>
        <translation>Orte der Kamera</translation>
    </message>
    <message>
        <source>Add the view</source>
        <translation>Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>The camera is at this moment where the view is now</source>
        <translation>Zu diesem Zeitpunkt ist die Kamera, wo die Ansicht jetzt ist</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Read…</source>
        <translation>Lesen…</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern…</translation>
    </message>
    <message>
        <source>For talus-cli animate --camera</source>
        <translation>Für talus-cli animate --camera</translation>
    </message>
    <message>
        <source>Read camera keys</source>
        <translation>Orte der Kamera lesen</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Save the camera keys</source>
        <translation>Orte der Kamera speichern</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Stands at, m</source>
        <translation>Steht bei, m</translation>
    </message>
    <message>
        <source>Looks to, m</source>
        <translation>Blickt nach, m</translation>
    </message>
    <message>
        <source>real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>There are no frames yet</source>
        <translation>Es gibt noch keine Bilder</translation>
    </message>
    <message>
        <source>Add a key, or let the camera stand still</source>
        <translation>Einen Ort hinzufügen oder die Kamera stehen lassen</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>beside the view</source>
        <translation>neben der Ansicht</translation>
    </message>
    <message>
        <source>over the view, as outlines</source>
        <translation>über der Ansicht, als Umrisse</translation>
    </message>
    <message>
        <source>Compared results</source>
        <translation>Verglichene Ergebnisse</translation>
    </message>
    <message>
        <source>Over the view those that were opened first for comparing are drawn</source>
        <translation>Über der Ansicht werden die gezeichnet, die zuerst zum Vergleichen geöffnet wurden</translation>
    </message>
    <message>
        <source>Begins at</source>
        <translation>Beginnt bei</translation>
    </message>
    <message>
        <source>Ends at</source>
        <translation>Endet bei</translation>
    </message>
    <message>
        <source>first frame</source>
        <translation>erstes Bild</translation>
    </message>
    <message>
        <source>last frame</source>
        <translation>letztes Bild</translation>
    </message>
    <message>
        <source>Moment at which the film begins</source>
        <translation>Zeitpunkt, zu dem der Film beginnt</translation>
    </message>
    <message>
        <source>Moment of the model at which the film begins</source>
        <translation>Zeitpunkt des Modells, zu dem der Film beginnt</translation>
    </message>
    <message>
        <source>Moment at which the film ends</source>
        <translation>Zeitpunkt, zu dem der Film endet</translation>
    </message>
    <message>
        <source>Moment of the model at which the film ends</source>
        <translation>Zeitpunkt des Modells, zu dem der Film endet</translation>
    </message>
    <message>
        <source>No frames lie between its beginning and its end</source>
        <translation>Zwischen seinem Anfang und seinem Ende liegen keine Bilder</translation>
    </message>
</context>
<context>
    <name>talus::FormField</name>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>change %1 of %2</source>
        <translation>%1 von %2 ändern</translation>
    </message>
    <message>
        <source>leave out %1 of %2</source>
        <translation>%1 von %2 weglassen</translation>
    </message>
</context>
<context>
    <name>talus::Guards</name>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungesicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gesichert sind.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Sichern unter…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Results would be replaced</source>
        <translation>Ergebnisse würden ersetzt</translation>
    </message>
    <message>
        <source>%1 holds the results of a run of %2.</source>
        <translation>%1 enthält die Ergebnisse eines Laufs von %2.</translation>
    </message>
    <message>
        <source>The new run writes its results in their place.</source>
        <translation>Der neue Lauf schreibt seine Ergebnisse an deren Stelle.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Keep as %1</source>
        <translation>Als %1 behalten</translation>
    </message>
    <message>
        <source>kept the results of before as %1</source>
        <translation>die früheren Ergebnisse als %1 behalten</translation>
    </message>
    <message>
        <source>A run goes on</source>
        <translation>Ein Lauf ist im Gange</translation>
    </message>
    <message>
        <source>The run of %1 has come to %2 %.</source>
        <translation>Der Lauf von %1 ist bei %2 %.</translation>
    </message>
    <message>
        <source>Stopped, it ends after its step, and its results until then stay.</source>
        <translation>Angehalten endet er nach seinem Schritt; seine Ergebnisse bis dahin bleiben.</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Anhalten und schließen</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>In the background it goes on without the window, to the same numbers; open the project again to see how far it is, or to stop it.</source>
        <translation>Im Hintergrund geht er ohne das Fenster weiter, zu denselben Zahlen; das wieder geöffnete Projekt zeigt, wie weit er ist, und hält ihn an.</translation>
    </message>
    <message>
        <source>Go on in the background</source>
        <translation>Im Hintergrund weiter</translation>
    </message>
</context>
<context>
    <name>talus::HardCaseList</name>
    <message>
        <source>holds</source>
        <translation>hält</translation>
    </message>
    <message>
        <source>falls short, known</source>
        <translation>bleibt zurück, bekannt</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>hält nicht</translation>
    </message>
</context>
<context>
    <name>talus::HistoryPanel</name>
    <message>
        <source>Displacement</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Open–close iterations</source>
        <translation>Open–close-Iterationen</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Curves of monitors and energies appear here as soon as a run makes steps.</source>
        <translation>Kurven von Messpunkten und Energien erscheinen hier, sobald ein Lauf Schritte macht.</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>stick</source>
        <translation>haftend</translation>
    </message>
    <message>
        <source>slip</source>
        <translation>gleitend</translation>
    </message>
    <message>
        <source>a step</source>
        <translation>je Schritt</translation>
    </message>
    <message>
        <source>kinetic</source>
        <translation>kinetisch</translation>
    </message>
    <message>
        <source>elastic</source>
        <translation>elastisch</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>loss</source>
        <translation>Verlust</translation>
    </message>
</context>
<context>
    <name>talus::ImportDialog</name>
    <message>
        <source>Import %1</source>
        <translation>%1 einlesen</translation>
    </message>
    <message>
        <source>Name of the solid</source>
        <translation>Name des Körpers</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>How it is to be read</source>
        <translation>Wie es zu lesen ist</translation>
    </message>
    <message>
        <source>What it is</source>
        <translation>Was es ist</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Ausdehnung</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>a body of rock</source>
        <translation>einen Felskörper</translation>
    </message>
    <message>
        <source>ground, with rock below it</source>
        <translation>Gelände, darunter Fels</translation>
    </message>
    <message>
        <source>What the file holds</source>
        <translation>Was die Datei enthält</translation>
    </message>
    <message>
        <source>The file holds</source>
        <translation>Die Datei enthält</translation>
    </message>
    <message>
        <source>other</source>
        <translation>andere</translation>
    </message>
    <message>
        <source>Unit of the file</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>Metres per unit of the file</source>
        <translation>Meter je Einheit der Datei</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Metres per unit</source>
        <translation>Meter je Einheit</translation>
    </message>
    <message>
        <source>a unit is longer than nothing; give metres per unit of the file</source>
        <translation>eine Einheit ist länger als nichts; geben Sie Meter je Einheit der Datei an</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>Axis of the file that points upwards</source>
        <translation>Achse der Datei, die nach oben zeigt</translation>
    </message>
    <message>
        <source>Upwards is</source>
        <translation>Oben ist</translation>
    </message>
    <message>
        <source>Base of the rock</source>
        <translation>Unterseite des Felses</translation>
    </message>
    <message>
        <source>below the ground</source>
        <translation>unter dem Gelände</translation>
    </message>
    <message>
        <source>Level of the flat underside, below all of the ground</source>
        <translation>Höhe der ebenen Unterseite, unter dem ganzen Gelände</translation>
    </message>
    <message>
        <source>Tolerance of the ground</source>
        <translation>Toleranz des Geländes</translation>
    </message>
    <message>
        <source>How far the thinned surface may lie from what the file has; 0 keeps every point</source>
        <translation>Wie weit die ausgedünnte Oberfläche von der Datei abweichen darf; 0 behält jeden Punkt</translation>
    </message>
    <message>
        <source>Base at z</source>
        <translation>Unterseite bei z</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>a tolerance is not below 0; 0 keeps every point</source>
        <translation>eine Toleranz ist nicht kleiner als 0; 0 behält jeden Punkt</translation>
    </message>
    <message>
        <source>The project&apos;s origin is %1, %2, %3: the file&apos;s coordinates are taken less this.</source>
        <translation>Der Ursprung des Projekts ist %1, %2, %3: er wird von den Koordinaten der Datei abgezogen.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Einlesen</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Shift by %1, %2, %3</source>
        <translation>Um %1, %2, %3 verschieben</translation>
    </message>
    <message>
        <source>It lies far from zero: near a local origin it keeps all its digits. What the window shows of places is still in the file&apos;s coordinates.</source>
        <translation>Es liegt weit von null: nahe an einem lokalen Ursprung behält es alle Stellen. Orte zeigt das Fenster weiterhin in den Koordinaten der Datei.</translation>
    </message>
    <message>
        <source> Solids from files follow; those that have coordinates of their own keep them.</source>
        <translation> Körper aus Dateien folgen; solche mit eigenen Koordinaten behalten sie.</translation>
    </message>
    <message>
        <source>Drag turns it, the wheel zooms.</source>
        <translation>Ziehen dreht, das Rad vergrößert.</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>E %1
N %2
Z %3</source>
        <translation>O %1
N %2
Z %3</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>Nothing is wrong with its surface</source>
        <translation>An der Oberfläche ist nichts auszusetzen</translation>
    </message>
    <message>
        <source>No rock can be made of this surface; it is marked where it is wrong.</source>
        <translation>Aus dieser Oberfläche lässt sich kein Fels machen; wo sie falsch ist, ist markiert.</translation>
    </message>
    <message>
        <source>none, it is not closed</source>
        <translation>keines, sie ist nicht geschlossen</translation>
    </message>
    <message>
        <source>%1: %2; %3</source>
        <translation>%1: %2; %3</translation>
    </message>
</context>
<context>
    <name>talus::JointActions</name>
    <message>
        <source>Joint through three points</source>
        <translation>Kluft durch drei Punkte</translation>
    </message>
    <message>
        <source>Joint along a face</source>
        <translation>Kluft entlang einer Fläche</translation>
    </message>
    <message>
        <source>Assign joint to a face</source>
        <translation>Fläche eine Kluft zuordnen</translation>
    </message>
    <message>
        <source>Joint between these two blocks</source>
        <translation>Kluft zwischen diesen zwei Blöcken</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>Zuerst ein Projekt öffnen</translation>
    </message>
    <message>
        <source>The project has no solid yet</source>
        <translation>Das Projekt hat noch keinen Körper</translation>
    </message>
    <message>
        <source>There are no blocks yet</source>
        <translation>Es gibt noch keine Blöcke</translation>
    </message>
    <message>
        <source>The project has no joint yet</source>
        <translation>Das Projekt hat noch keine Kluft</translation>
    </message>
    <message>
        <source>Select two blocks first</source>
        <translation>Zuerst zwei Blöcke wählen</translation>
    </message>
    <message>
        <source>Click a point of the joint</source>
        <translation>Auf einen Punkt der Kluft klicken</translation>
    </message>
    <message>
        <source>joint through three points</source>
        <translation>Kluft durch drei Punkte</translation>
    </message>
    <message>
        <source>Click a face that the joint lies along</source>
        <translation>Auf eine Fläche klicken, an der die Kluft liegt</translation>
    </message>
    <message>
        <source>joint along a face</source>
        <translation>Kluft entlang einer Fläche</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Click a face between two blocks, for %1 (E draws them apart)</source>
        <translation>Auf eine Fläche zwischen zwei Blöcken klicken, für %1 (E zeichnet sie auseinander)</translation>
    </message>
    <message>
        <source>assign %1</source>
        <translation>%1 zuordnen</translation>
    </message>
    <message>
        <source>nothing is cut yet</source>
        <translation>noch ist nichts geschnitten</translation>
    </message>
    <message>
        <source>cut and mesh first</source>
        <translation>zuerst schneiden und vernetzen</translation>
    </message>
    <message>
        <source>this face has the joint %1</source>
        <translation>diese Fläche hat die Kluft %1</translation>
    </message>
    <message>
        <source>cut again, the cuts were changed</source>
        <translation>neu schneiden, die Schnitte haben sich geändert</translation>
    </message>
    <message>
        <source>this face lies on cut %1, which has the joint %2</source>
        <translation>diese Fläche liegt auf Schnitt %1, der die Kluft %2 hat</translation>
    </message>
    <message>
        <source>give the cut another joint</source>
        <translation>dem Schnitt eine andere Kluft geben</translation>
    </message>
    <message>
        <source>no block lies against this face</source>
        <translation>an dieser Fläche liegt kein Block an</translation>
    </message>
    <message>
        <source>click a face between two blocks</source>
        <translation>auf eine Fläche zwischen zwei Blöcken klicken</translation>
    </message>
    <message>
        <source>assign %1 between %2 and %3</source>
        <translation>%1 zwischen %2 und %3 zuordnen</translation>
    </message>
    <message>
        <source>%1 lies between %2 and %3 now</source>
        <translation>%1 liegt jetzt zwischen %2 und %3</translation>
    </message>
</context>
<context>
    <name>talus::JointHandles</name>
    <message>
        <source>   Enter</source>
        <translation>   Eingabetaste</translation>
    </message>
    <message>
        <source>dip direction %1°</source>
        <translation>Fallrichtung %1°</translation>
    </message>
    <message>
        <source>dip %1°</source>
        <translation>Fallwinkel %1°</translation>
    </message>
    <message>
        <source>radius %1 m</source>
        <translation>Radius %1 m</translation>
    </message>
    <message>
        <source>corner %1: %2, %3, %4 m</source>
        <translation>Ecke %1: %2, %3, %4 m</translation>
    </message>
    <message>
        <source>move along the normal</source>
        <translation>entlang der Normalen verschieben</translation>
    </message>
    <message>
        <source>%1%2 m</source>
        <translation>%1%2 m</translation>
    </message>
</context>
<context>
    <name>talus::KeyField</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
</context>
<context>
    <name>talus::KnownAnswers</name>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>gescheitert</translation>
    </message>
</context>
<context>
    <name>talus::LanguageMenu</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Spoken from the next start of Talus on</source>
        <translation>Gesprochen vom nächsten Start von Talus an</translation>
    </message>
    <message>
        <source>%1 is chosen</source>
        <translation>%1 ist gewählt</translation>
    </message>
    <message>
        <source>it is spoken from the next start of Talus on</source>
        <translation>gesprochen wird es vom nächsten Start von Talus an</translation>
    </message>
</context>
<context>
    <name>talus::LinePanel</name>
    <message>
        <source>Save as CSV…</source>
        <translation>Als CSV speichern …</translation>
    </message>
    <message>
        <source>The field along the line</source>
        <translation>Das Feld entlang der Linie</translation>
    </message>
    <message>
        <source>Choose two points</source>
        <translation>Zwei Punkte wählen</translation>
    </message>
    <message>
        <source>Click two points of the rock in the view: the field that is shown is followed between them</source>
        <translation>Zwei Punkte des Gesteins in der Ansicht anklicken: das gezeigte Feld wird zwischen ihnen verfolgt</translation>
    </message>
    <message>
        <source>Click both ends of the line</source>
        <translation>Beide Enden der Linie anklicken</translation>
    </message>
    <message>
        <source>Save the field along the line</source>
        <translation>Das Feld entlang der Linie speichern</translation>
    </message>
    <message>
        <source>Fields are followed along lines when there are results.</source>
        <translation>Felder werden entlang von Linien verfolgt, wenn es Ergebnisse gibt.</translation>
    </message>
    <message>
        <source>Two points of the rock make a line, along which the field is shown.</source>
        <translation>Zwei Punkte des Gesteins ergeben eine Linie, entlang der das Feld gezeigt wird.</translation>
    </message>
    <message>
        <source>The line meets no rock in this frame.</source>
        <translation>Die Linie trifft in diesem Bild kein Gestein.</translation>
    </message>
    <message>
        <source>%1 long</source>
        <translation>%1 lang</translation>
    </message>
    <message>
        <source>Take the line away</source>
        <translation>Linie wegnehmen</translation>
    </message>
</context>
<context>
    <name>talus::ListField</name>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add one to %1</source>
        <translation>Eins zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>add to %1</source>
        <translation>zu %1 hinzufügen</translation>
    </message>
    <message>
        <source>Take it away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>take %1 away</source>
        <translation>%1 wegnehmen</translation>
    </message>
</context>
<context>
    <name>talus::LoadActions</name>
    <message>
        <source>Load at a point…</source>
        <translation>Last an einem Punkt…</translation>
    </message>
    <message>
        <source>Click the point where the load acts</source>
        <translation>Auf den Punkt klicken, an dem die Last wirkt</translation>
    </message>
    <message>
        <source>Load on a face…</source>
        <translation>Last auf einer Fläche…</translation>
    </message>
    <message>
        <source>Click the face that the load acts on</source>
        <translation>Auf die Fläche klicken, auf die die Last wirkt</translation>
    </message>
    <message>
        <source>Load on a block…</source>
        <translation>Last auf einem Block…</translation>
    </message>
    <message>
        <source>Click the block that the load acts on</source>
        <translation>Auf den Block klicken, auf den die Last wirkt</translation>
    </message>
    <message>
        <source>Hold a point</source>
        <translation>Punkt festhalten</translation>
    </message>
    <message>
        <source>Click the point that is to be held</source>
        <translation>Auf den Punkt klicken, der festgehalten wird</translation>
    </message>
    <message>
        <source>Hold a face at its corners</source>
        <translation>Fläche an ihren Ecken festhalten</translation>
    </message>
    <message>
        <source>Click the face whose corners are to be held</source>
        <translation>Auf die Fläche klicken, deren Ecken festgehalten werden</translation>
    </message>
    <message>
        <source>Hold a block</source>
        <translation>Block festhalten</translation>
    </message>
    <message>
        <source>Click the block that is to be held</source>
        <translation>Auf den Block klicken, der festgehalten wird</translation>
    </message>
    <message>
        <source>Velocity of blocks…</source>
        <translation>Geschwindigkeit von Blöcken…</translation>
    </message>
    <message>
        <source>Click the block that moves at the start</source>
        <translation>Auf den Block klicken, der sich am Anfang bewegt</translation>
    </message>
    <message>
        <source>Monitor here</source>
        <translation>Hier messen</translation>
    </message>
    <message>
        <source>Click the point whose history is to be recorded</source>
        <translation>Auf den Punkt klicken, dessen Verlauf aufgezeichnet wird</translation>
    </message>
    <message>
        <source>Monitor with stress here</source>
        <translation>Hier mit Spannung messen</translation>
    </message>
    <message>
        <source>Click the point whose stress is to be recorded</source>
        <translation>Auf den Punkt klicken, dessen Spannung aufgezeichnet wird</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>Zuerst ein Projekt öffnen</translation>
    </message>
    <message>
        <source>Cut and mesh first: there are no blocks to point at yet</source>
        <translation>Zuerst schneiden und vernetzen: es gibt noch keine Blöcke, auf die man zeigen könnte</translation>
    </message>
    <message>
        <source>New load</source>
        <translation>Neue Last</translation>
    </message>
    <message>
        <source>On block %1, at %2 m</source>
        <translation>Auf Block %1, bei %2 m</translation>
    </message>
    <message>
        <source>add a load on %1</source>
        <translation>Last auf %1 hinzufügen</translation>
    </message>
    <message>
        <source>hold a point of %1</source>
        <translation>Punkt von %1 festhalten</translation>
    </message>
    <message>
        <source>hold a face of %1</source>
        <translation>Fläche von %1 festhalten</translation>
    </message>
    <message>
        <source>hold block %1</source>
        <translation>Block %1 festhalten</translation>
    </message>
    <message>
        <source>Initial velocity</source>
        <translation>Anfangsgeschwindigkeit</translation>
    </message>
    <message>
        <source>Of %1</source>
        <translation>Von %1</translation>
    </message>
    <message>
        <source>give %1 a velocity</source>
        <translation>%1 eine Geschwindigkeit geben</translation>
    </message>
    <message>
        <source>give %1 blocks a velocity</source>
        <translation>%1 Blöcken eine Geschwindigkeit geben</translation>
    </message>
    <message>
        <source>add a monitor on %1</source>
        <translation>Messpunkt auf %1 hinzufügen</translation>
    </message>
</context>
<context>
    <name>talus::MainWindow</name>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>cancelled; no file was left</source>
        <translation>abgebrochen; keine Datei blieb übrig</translation>
    </message>
    <message>
        <source>%1%2 - Talus</source>
        <translation>%1%2 - Talus</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>stopping the run before the window closes</source>
        <translation>der Lauf wird angehalten, bevor das Fenster schließt</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>No file has been opened yet</source>
        <translation>Noch wurde keine Datei geöffnet</translation>
    </message>
    <message>
        <source>Open a project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Talus projects (*.talus)</source>
        <translation>Talus-Projekte (*.talus)</translation>
    </message>
    <message>
        <source>Open a results folder</source>
        <translation>Ergebnisordner öffnen</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Projekt sichern</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Bild sichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Save a film</source>
        <translation>Film sichern</translation>
    </message>
    <message>
        <source>Films (*.mp4 *.gif)</source>
        <translation>Filme (*.mp4 *.gif)</translation>
    </message>
    <message>
        <source>About Talus</source>
        <translation>Über Talus</translation>
    </message>
    <message>
        <source>&lt;b&gt;Talus %1&lt;/b&gt;&lt;p&gt;Rock slopes that come apart along joints: three-dimensional discontinuous deformation analysis with tetrahedral finite elements.&lt;/p&gt;&lt;p&gt;GPL-3.0-or-later. Built on Qt, VTK, gmsh, SuiteSparse, HDF5 and FFmpeg. Typeface Inter, OFL 1.1.&lt;/p&gt;</source>
        <translation>&lt;b&gt;Talus %1&lt;/b&gt;&lt;p&gt;Felshänge, die entlang ihrer Klüfte auseinandergehen: dreidimensionale diskontinuierliche Deformationsanalyse mit Tetraeder-Elementen.&lt;/p&gt;&lt;p&gt;GPL-3.0-or-later. Gebaut auf Qt, VTK, gmsh, SuiteSparse, HDF5 und FFmpeg. Schrift Inter, OFL 1.1.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Under the mouse: east, north and height in the coordinates of the survey</source>
        <translation>Unter der Maus: Ost, Nord und Höhe in den Koordinaten der Vermessung</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>Save a report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Reports (*.html *.pdf)</source>
        <translation>Berichte (*.html *.pdf)</translation>
    </message>
    <message>
        <source>A new folder for the files</source>
        <translation>Ein neuer Ordner für die Dateien</translation>
    </message>
    <message>
        <source>New folders (*)</source>
        <translation>Neue Ordner (*)</translation>
    </message>
    <message>
        <source>Files (*%1)</source>
        <translation>Dateien (*%1)</translation>
    </message>
    <message>
        <source>Views of results (*.json)</source>
        <translation>Ansichten von Ergebnissen (*.json)</translation>
    </message>
    <message>
        <source>Save the view</source>
        <translation>Ansicht speichern</translation>
    </message>
    <message>
        <source>Open a view</source>
        <translation>Ansicht öffnen</translation>
    </message>
    <message>
        <source>Saved the view as %1</source>
        <translation>Ansicht gespeichert als %1</translation>
    </message>
    <message>
        <source>Compare with a results folder</source>
        <translation>Mit einem Ergebnisordner vergleichen</translation>
    </message>
    <message>
        <source>the window closes as soon as the run goes on in the background</source>
        <translation>das Fenster schließt sich, sobald der Lauf im Hintergrund weitergeht</translation>
    </message>
</context>
<context>
    <name>talus::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
</context>
<context>
    <name>talus::MeasureCard</name>
    <message>
        <source>Measure: click a face</source>
        <translation>Messen: eine Fläche anklicken</translation>
    </message>
    <message>
        <source>Measure: click two points</source>
        <translation>Messen: zwei Punkte anklicken</translation>
    </message>
    <message>
        <source>Measure: click three points</source>
        <translation>Messen: drei Punkte anklicken</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Angle and plane</source>
        <translation>Winkel und Ebene</translation>
    </message>
    <message>
        <source>What is measured</source>
        <translation>Was gemessen wird</translation>
    </message>
    <message>
        <source>Copy what was measured</source>
        <translation>Gemessenes kopieren</translation>
    </message>
    <message>
        <source>End measuring (Esc)</source>
        <translation>Messen beenden (Esc)</translation>
    </message>
    <message>
        <source>Click a face.</source>
        <translation>Klicken Sie eine Fläche an.</translation>
    </message>
    <message>
        <source>Click point %1 of %2.</source>
        <translation>Klicken Sie Punkt %1 von %2 an.</translation>
    </message>
</context>
<context>
    <name>talus::MeshPanel</name>
    <message>
        <source>Mesh of each block</source>
        <translation>Netz jedes Blocks</translation>
    </message>
    <message>
        <source>Radius ratio</source>
        <translation>Halbmesserverhältnis</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>Kleinster Winkel</translation>
    </message>
    <message>
        <source>Measure of quality</source>
        <translation>Maß der Güte</translation>
    </message>
    <message>
        <source>3 × inscribed over circumscribed radius: 1 of a regular tetrahedron, 0 of a flat one; or the smallest angle between two of its faces: 70.5° of a regular one</source>
        <translation>3 × Inkugel- über Umkugelhalbmesser: 1 eines regelmäßigen Tetraeders, 0 eines flachen; oder der kleinste Winkel zwischen zwei seiner Flächen: 70.5° eines regelmäßigen</translation>
    </message>
    <message>
        <source>The worst tetrahedra</source>
        <translation>Die schlechtesten Tetraeder</translation>
    </message>
    <message>
        <source>A click lets the view go there</source>
        <translation>Ein Klick lässt die Ansicht hingehen</translation>
    </message>
    <message>
        <source>Mesh, before the last change</source>
        <translation>Netz, vor der letzten Änderung</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Not meshed yet.</source>
        <translation>Noch nicht vernetzt.</translation>
    </message>
    <message>
        <source>Worst in</source>
        <translation>Schlechteste in</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Angle °</source>
        <translation>Winkel °</translation>
    </message>
    <message>
        <source>quality %1, %2°</source>
        <translation>Güte %1, %2°</translation>
    </message>
    <message>
        <source>Refine near a place</source>
        <translation>Um einen Ort verfeinern</translation>
    </message>
    <message>
        <source>A click in the view says where the mesh becomes finer; the form of the mesh says how far and how much</source>
        <translation>Ein Klick in die Ansicht sagt, wo das Netz feiner wird; das Formular des Netzes sagt, wie weit und wie sehr</translation>
    </message>
    <message>
        <source>Meshed anew: about %1 tetrahedra, more than the %2 that are allowed</source>
        <translation>Neu vernetzt: etwa %1 Tetraeder, mehr als die erlaubten %2</translation>
    </message>
    <message>
        <source>Meshed anew: about %1 tetrahedra, %2 unknowns, %3, %4</source>
        <translation>Neu vernetzt: etwa %1 Tetraeder, %2 Unbekannte, %3, %4</translation>
    </message>
    <message>
        <source>Click the place near which the mesh shall be finer</source>
        <translation>Klicken Sie den Ort an, um den das Netz feiner werden soll</translation>
    </message>
    <message>
        <source>refine the mesh near a place</source>
        <translation>Netz um einen Ort verfeinern</translation>
    </message>
    <message>
        <source>Refine near a face</source>
        <translation>Bei einer Fläche verfeinern</translation>
    </message>
    <message>
        <source>A click on a flat face says along which the mesh becomes finer; the form of the mesh says how far and how much</source>
        <translation>Ein Klick auf eine ebene Fläche sagt, entlang welcher das Netz feiner wird; das Formular des Netzes sagt, wie weit und wie viel</translation>
    </message>
    <message>
        <source>Click the face near which the mesh shall be finer</source>
        <translation>Klicken Sie die Fläche an, bei der das Netz feiner werden soll</translation>
    </message>
    <message>
        <source>refine the mesh near a face</source>
        <translation>das Netz bei einer Fläche verfeinern</translation>
    </message>
    <message>
        <source>There is no rock yet</source>
        <translation>Noch ist kein Fels da</translation>
    </message>
</context>
<context>
    <name>talus::MoveDialog</name>
    <message>
        <source>By</source>
        <translation>Um</translation>
    </message>
    <message>
        <source>Each further by</source>
        <translation>Jede weitere um</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopien</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Um den Punkt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 verschieben</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>%1 drehen</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>%1 skalieren</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>%1 kopieren</translation>
    </message>
    <message>
        <source>east, x</source>
        <translation>Ost, x</translation>
    </message>
    <message>
        <source>north, y</source>
        <translation>Nord, y</translation>
    </message>
    <message>
        <source>up, z</source>
        <translation>oben, z</translation>
    </message>
    <message>
        <source>upright, z</source>
        <translation>senkrecht, z</translation>
    </message>
    <message>
        <source>to the east, x</source>
        <translation>nach Osten, x</translation>
    </message>
    <message>
        <source>to the north, y</source>
        <translation>nach Norden, y</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>By the right hand: about the upright axis, counter-clockwise seen from above</source>
        <translation>Nach der rechten Hand: um die senkrechte Achse, von oben gesehen gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>talus::NewDialog</name>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>Leer</translation>
    </message>
    <message>
        <source>Empty project</source>
        <translation>Leeres Projekt</translation>
    </message>
    <message>
        <source>To be filled in the window. What is still missing is listed under Problems.</source>
        <translation>Im Fenster zu füllen. Was noch fehlt, steht unter Probleme.</translation>
    </message>
    <message>
        <source>A number is not one that the template takes</source>
        <translation>Eine Zahl ist keine, die die Vorlage nimmt</translation>
    </message>
</context>
<context>
    <name>talus::ObjectField</name>
    <message>
        <source>change %1 of %2</source>
        <translation>%1 von %2 ändern</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation>%1 setzen</translation>
    </message>
    <message>
        <source>set %1 of %2</source>
        <translation>%1 von %2 setzen</translation>
    </message>
    <message>
        <source>Leave it out: %1</source>
        <translation>Weglassen: %1</translation>
    </message>
    <message>
        <source>leave out %1 of %2</source>
        <translation>%1 von %2 weglassen</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>use the %1 settings of %2</source>
        <translation>die Einstellungen %1 für %2 nehmen</translation>
    </message>
    <message>
        <source>all fields</source>
        <translation>alle Felder</translation>
    </message>
    <message>
        <source>what the file says</source>
        <translation>was die Datei sagt</translation>
    </message>
    <message>
        <source>nothing more</source>
        <translation>nichts weiter</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Draft: steps as long as loose limits allow. Standard: what the program takes of itself. Reference: tight limits, no block sleeps.</source>
        <translation>Grob: Schritte so lang, wie lockere Grenzen erlauben. Üblich: was das Programm von selbst nimmt. Fein: enge Grenzen, kein Block ruht.</translation>
    </message>
    <message>
        <source>How many of the fields are listed below</source>
        <translation>Wie viele der Felder unten aufgeführt sind</translation>
    </message>
</context>
<context>
    <name>talus::PageTable</name>
    <message>
        <source>What the project holds of this page</source>
        <translation>Was das Projekt zu dieser Seite enthält</translation>
    </message>
</context>
<context>
    <name>talus::PasteJoints</name>
    <message>
        <source>Paste joints</source>
        <translation>Klüfte einfügen</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>A joint a line: dip, dip direction (or strike), set, x, y, z. With a header or without; tabs, semicolons, commas or blanks.</source>
        <translation>Eine Kluft je Zeile: Fallen, Fallrichtung (oder Streichen), Schar, x, y, z. Mit Kopfzeile oder ohne; Tabulatoren, Strichpunkte, Kommas oder Leerzeichen.</translation>
    </message>
    <message>
        <source>Text of the table</source>
        <translation>Text der Tabelle</translation>
    </message>
    <message>
        <source>What is read</source>
        <translation>Was gelesen wurde</translation>
    </message>
    <message>
        <source>Joints that were read</source>
        <translation>Gelesene Klüfte</translation>
    </message>
    <message>
        <source>Joints without a place go through</source>
        <translation>Klüfte ohne Ort gehen durch</translation>
    </message>
    <message>
        <source>Place %1</source>
        <translation>Ort %1</translation>
    </message>
    <message>
        <source>New sets have the strength of</source>
        <translation>Neue Scharen haben die Festigkeit von</translation>
    </message>
    <message>
        <source>Strength of new sets</source>
        <translation>Festigkeit neuer Scharen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>φ %1°, no cohesion</source>
        <translation>φ %1°, keine Kohäsion</translation>
    </message>
    <message>
        <source>Open a table of joints</source>
        <translation>Klufttabelle öffnen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Add %1, leave %2 out</source>
        <translation>%1 hinzufügen, %2 auslassen</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Dip, °</source>
        <translation>Fallen, °</translation>
    </message>
    <message>
        <source>Direction, °</source>
        <translation>Richtung, °</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>x, m</source>
        <translation>x, m</translation>
    </message>
    <message>
        <source>y, m</source>
        <translation>y, m</translation>
    </message>
    <message>
        <source>z, m</source>
        <translation>z, m</translation>
    </message>
    <message>
        <source>Spacing, m</source>
        <translation>Abstand, m</translation>
    </message>
    <message>
        <source>Persistence, m</source>
        <translation>Persistenz, m</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>paste %1</source>
        <translation>%1 einfügen</translation>
    </message>
    <message>
        <source>Open table or drawing…</source>
        <translation>Tabelle oder Zeichnung öffnen…</translation>
    </message>
    <message>
        <source>Tables and drawings (*.csv *.tsv *.txt *.dxf);;All files (*)</source>
        <translation>Tabellen und Zeichnungen (*.csv *.tsv *.txt *.dxf);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source># faces of %1</source>
        <translation># Flächen von %1</translation>
    </message>
    <message>
        <source>each joint ends at the corners of its face</source>
        <translation>jede Kluft endet an den Ecken ihrer Fläche</translation>
    </message>
    <message>
        <source>Copy a table in a spreadsheet and paste it on the left, or open a table or a drawing with faces (DXF).</source>
        <translation>Eine Tabelle in einer Tabellenkalkulation kopieren und links einfügen, oder eine Tabelle oder eine Zeichnung mit Flächen (DXF) öffnen.</translation>
    </message>
    <message>
        <source>A line with a spacing becomes</source>
        <translation>Eine Zeile mit einem Abstand wird</translation>
    </message>
    <message>
        <source>parallel planes through all of the rock</source>
        <translation>parallele Ebenen durch den ganzen Fels</translation>
    </message>
    <message>
        <source>one plane</source>
        <translation>eine Ebene</translation>
    </message>
    <message>
        <source>What a spacing makes</source>
        <translation>Was ein Abstand bewirkt</translation>
    </message>
    <message>
        <source>with their spacings %1 in the rock</source>
        <translation>mit ihren Abständen %1 im Fels</translation>
    </message>
    <message>
        <source>spacing is not used: every line becomes one plane</source>
        <translation>der Abstand wird nicht verwendet: jede Zeile wird eine Ebene</translation>
    </message>
    <message>
        <source>spacing is not used while there is no rock: every line becomes one plane</source>
        <translation>der Abstand wird nicht verwendet, solange kein Fels da ist: jede Zeile wird eine Ebene</translation>
    </message>
    <message>
        <source>persistence is shown but not used: planes have no end</source>
        <translation>die Persistenz wird gezeigt, aber nicht verwendet: Ebenen enden nicht</translation>
    </message>
</context>
<context>
    <name>talus::PlacePicker</name>
    <message>
        <source>Esc ends it</source>
        <translation>Esc beendet es</translation>
    </message>
    <message>
        <source>End picking (Esc)</source>
        <translation>Zeigen beenden (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>talus::Plot</name>
    <message>
        <source>Nothing to plot yet</source>
        <translation>Noch nichts zu zeichnen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>talus::ProblemCount</name>
    <message>
        <source>What is wrong with the project, what is odd, what may be on purpose; a click lists it</source>
        <translation>Was am Projekt falsch ist, was seltsam, was Absicht sein mag; ein Klick listet es auf</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Keine Probleme</translation>
    </message>
    <message>
        <source>Problems: %1</source>
        <translation>Probleme: %1</translation>
    </message>
</context>
<context>
    <name>talus::ProblemList</name>
    <message>
        <source>No problems.</source>
        <translation>Keine Probleme.</translation>
    </message>
</context>
<context>
    <name>talus::ProblemRow</name>
    <message>
        <source>Go there</source>
        <translation>Hingehen</translation>
    </message>
    <message>
        <source>Selects it and puts the keyboard into its field (Enter)</source>
        <translation>Wählt es und setzt die Tastatur in sein Feld (Eingabe)</translation>
    </message>
</context>
<context>
    <name>talus::ProblemStrip</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>talus::ProjectPreview</name>
    <message>
        <source>Preview of the project</source>
        <translation>Vorschau des Projekts</translation>
    </message>
    <message>
        <source>Nothing in it yet: materials, joints and solids are added in the window.</source>
        <translation>Noch ist nichts darin: Werkstoffe, Klüfte und Körper werden im Fenster hinzugefügt.</translation>
    </message>
    <message>
        <source>Cutting …</source>
        <translation>Wird geschnitten …</translation>
    </message>
</context>
<context>
    <name>talus::ProjectProblems</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1; and %2 more under Problems</source>
        <translation>%1; und %2 weitere unter Probleme</translation>
    </message>
</context>
<context>
    <name>talus::ProjectStudy</name>
    <message>
        <source>Open a project first</source>
        <translation>Zuerst ein Projekt öffnen</translation>
    </message>
    <message>
        <source>A study is made of the project&apos;s file: save it first</source>
        <translation>Untersucht wird die Datei des Projekts: zuerst sichern</translation>
    </message>
    <message>
        <source>The study begins</source>
        <translation>Die Untersuchung beginnt</translation>
    </message>
    <message>
        <source>accuracy study</source>
        <translation>Genauigkeitsuntersuchung</translation>
    </message>
    <message>
        <source>what has ended is kept</source>
        <translation>was fertig ist, bleibt</translation>
    </message>
    <message>
        <source>The study has all of these runs</source>
        <translation>Die Studie hat alle diese Läufe</translation>
    </message>
</context>
<context>
    <name>talus::ProjectTree</name>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>New %1</source>
        <translation>Neu: %1</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Neu…</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>not cut</source>
        <translation>nicht geschnitten</translation>
    </message>
    <message>
        <source>not made</source>
        <translation>nicht gemacht</translation>
    </message>
    <message>
        <source>%1 tet</source>
        <translation>%1 Tet</translation>
    </message>
    <message>
        <source>mesh sizes</source>
        <translation>Netzweiten</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>by solid</source>
        <translation>je Körper</translation>
    </message>
    <message>
        <source>%1 kg/m³</source>
        <translation>%1 kg/m³</translation>
    </message>
    <message>
        <source>solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>output</source>
        <translation>Ausgabe</translation>
    </message>
    <message>
        <source>every %1 s</source>
        <translation>alle %1 s</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>φ %1°</source>
        <translation>φ %1°</translation>
    </message>
    <message>
        <source>cut %1, %2</source>
        <translation>Schnitt %1, %2</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>named</source>
        <translation>benannt</translation>
    </message>
    <message>
        <source>merge %1</source>
        <translation>Zusammenfassung %1</translation>
    </message>
    <message>
        <source>splinters</source>
        <translation>Splitter</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
    <message>
        <source>load on %1</source>
        <translation>Last auf %1</translation>
    </message>
    <message>
        <source>%1 kN</source>
        <translation>%1 kN</translation>
    </message>
    <message>
        <source>by table</source>
        <translation>nach Tabelle</translation>
    </message>
    <message>
        <source>support of %1</source>
        <translation>Lager von %1</translation>
    </message>
    <message>
        <source>velocity of %1</source>
        <translation>Geschwindigkeit von %1</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>stress in situ %1</source>
        <translation>Primärspannung %1</translation>
    </message>
    <message>
        <source>every block</source>
        <translation>alle Blöcke</translation>
    </message>
    <message>
        <source>%1 more in the table</source>
        <translation>%1 weitere in der Tabelle</translation>
    </message>
    <message>
        <source>outdated</source>
        <translation>veraltet</translation>
    </message>
</context>
<context>
    <name>talus::PropertyPanel</name>
    <message>
        <source>Duplicate</source>
        <translation>Verdoppeln</translation>
    </message>
    <message>
        <source>Move up the list</source>
        <translation>In der Liste nach oben</translation>
    </message>
    <message>
        <source>Move down the list</source>
        <translation>In der Liste nach unten</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Eigenschaften</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>nothing is selected</source>
        <translation>nichts gewählt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>chosen: %1</source>
        <translation>gewählt: %1</translation>
    </message>
    <message>
        <source>%1 blocks</source>
        <translation>%1 Blöcke</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>at the time in view</source>
        <translation>zur gezeigten Zeit</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>before the last change</source>
        <translation>vor der letzten Änderung</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>%1 t</source>
        <translation>%1 t</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>Joints it touches</source>
        <translation>Berührte Klüfte</translation>
    </message>
    <message>
        <source>facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>Name it, or change it…</source>
        <translation>Benennen oder ändern…</translation>
    </message>
    <message>
        <source>Change it…</source>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>Name, body, material and mesh size of this block alone</source>
        <translation>Name, Verhalten, Werkstoff und Netzweite dieses Blocks allein</translation>
    </message>
    <message>
        <source>name a block</source>
        <translation>Block benennen</translation>
    </message>
    <message>
        <source>Excavate it</source>
        <translation>Ausbrechen</translation>
    </message>
    <message>
        <source>Cuts it and leaves it out; the page Blocks brings it back (Delete)</source>
        <translation>Schneidet ihn und lässt ihn aus; die Seite Blöcke holt ihn zurück (Entf)</translation>
    </message>
</context>
<context>
    <name>talus::QualityChart</name>
    <message>
        <source>How well shaped the tetrahedra are</source>
        <translation>Wie gut die Tetraeder geformt sind</translation>
    </message>
    <message>
        <source>%1 tetrahedra, %2 of them below %3</source>
        <translation>%1 Tetraeder, %2 davon unter %3</translation>
    </message>
    <message>
        <source>Not meshed yet.</source>
        <translation>Noch nicht vernetzt.</translation>
    </message>
    <message>
        <source>%1 of %2 between %3 and %4</source>
        <translation>%1 von %2 zwischen %3 und %4</translation>
    </message>
</context>
<context>
    <name>talus::Rail</name>
    <message>
        <source>Changed since it was cut</source>
        <translation>Geändert, seit geschnitten wurde</translation>
    </message>
    <message>
        <source>Nothing has been solved yet</source>
        <translation>Noch ist nichts gerechnet</translation>
    </message>
    <message>
        <source>Changed since it was solved</source>
        <translation>Geändert, seit gerechnet wurde</translation>
    </message>
</context>
<context>
    <name>talus::RailItem</name>
    <message>
        <source>%1 (Ctrl+%2)</source>
        <translation>%1 (Strg+%2)</translation>
    </message>
</context>
<context>
    <name>talus::RangeFields</name>
    <message>
        <source>%1, lowest</source>
        <translation>%1, kleinster</translation>
    </message>
    <message>
        <source>%1, highest</source>
        <translation>%1, größter</translation>
    </message>
    <message>
        <source>The lowest value must be below the highest</source>
        <translation>Der kleinste Wert muss unter dem größten liegen</translation>
    </message>
</context>
<context>
    <name>talus::RecentButton</name>
    <message>
        <source>%1
There is no such file any more</source>
        <translation>%1
Diese Datei gibt es nicht mehr</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>verschwunden</translation>
    </message>
</context>
<context>
    <name>talus::RecoveryOffer</name>
    <message>
        <source>never saved</source>
        <translation>nie gesichert</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Ungesicherte Arbeit</translation>
    </message>
    <message>
        <source>Talus ended before this was saved</source>
        <translation>Talus endete, bevor dies gesichert war</translation>
    </message>
    <message>
        <source>Recovering opens it as it was kept; nothing is written to its file before you save.</source>
        <translation>Wiederherstellen öffnet es, wie es aufbewahrt wurde; vor dem Sichern wird nichts in seine Datei geschrieben.</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Offered again at the next start</source>
        <translation>Beim nächsten Start wieder angeboten</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
</context>
<context>
    <name>talus::RuleDialog</name>
    <message>
        <source>Select blocks by rule</source>
        <translation>Blöcke nach Regel wählen</translation>
    </message>
    <message>
        <source>Blocks that have, or are</source>
        <translation>Blöcke, die haben oder sind</translation>
    </message>
    <message>
        <source>become</source>
        <translation>werden</translation>
    </message>
    <message>
        <source>the selection</source>
        <translation>die Auswahl</translation>
    </message>
    <message>
        <source>part of the selection</source>
        <translation>Teil der Auswahl</translation>
    </message>
    <message>
        <source>no part of it any more</source>
        <translation>kein Teil von ihr mehr</translation>
    </message>
    <message>
        <source>all that stays of it</source>
        <translation>alles, was von ihr bleibt</translation>
    </message>
    <message>
        <source>What becomes of the selection</source>
        <translation>Was aus der Auswahl wird</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>There are no blocks yet</source>
        <translation>Es gibt noch keine Blöcke</translation>
    </message>
    <message>
        <source>Looking at the blocks</source>
        <translation>Sieht die Blöcke an</translation>
    </message>
    <message>
        <source>Say what is looked for</source>
        <translation>Sagen, was gesucht wird</translation>
    </message>
</context>
<context>
    <name>talus::RuleForm</name>
    <message>
        <source>volume below</source>
        <translation>Volumen unter</translation>
    </message>
    <message>
        <source>volume above</source>
        <translation>Volumen über</translation>
    </message>
    <message>
        <source>thinner than</source>
        <translation>dünner als</translation>
    </message>
    <message>
        <source>below a plane</source>
        <translation>unter einer Ebene</translation>
    </message>
    <message>
        <source>above a plane</source>
        <translation>über einer Ebene</translation>
    </message>
    <message>
        <source>touches a joint</source>
        <translation>berührt eine Kluft</translation>
    </message>
    <message>
        <source>on the free surface</source>
        <translation>an der freien Oberfläche</translation>
    </message>
    <message>
        <source>can leave</source>
        <translation>kann heraus</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>from a solid</source>
        <translation>aus einem Körper</translation>
    </message>
    <message>
        <source>name like</source>
        <translation>Name wie</translation>
    </message>
    <message>
        <source>What is asked of the blocks</source>
        <translation>Wonach die Blöcke gefragt werden</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Kluft</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>z =</source>
        <translation>z =</translation>
    </message>
    <message>
        <source>Through the three places picked</source>
        <translation>Durch die drei gezeigten Stellen</translation>
    </message>
    <message>
        <source>Pick three places in the view</source>
        <translation>Drei Stellen in der Ansicht zeigen</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>Click three places that the plane goes through</source>
        <translation>Auf drei Stellen klicken, durch die die Ebene geht</translation>
    </message>
    <message>
        <source>in any way</source>
        <translation>irgendwie</translation>
    </message>
    <message>
        <source>How</source>
        <translation>Wie</translation>
    </message>
    <message>
        <source>whatever it is</source>
        <translation>was immer er ist</translation>
    </message>
    <message>
        <source>F below</source>
        <translation>F unter</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>* stands for any letters, ? for one; without these the letters are looked for in the name</source>
        <translation>* steht für beliebige Buchstaben, ? für einen; ohne sie werden die Buchstaben im Namen gesucht</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
</context>
<context>
    <name>talus::RunList</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Share of the runs that is done</source>
        <translation>Erledigter Anteil der Läufe</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Export as JSON…</source>
        <translation>Als JSON ausgeben…</translation>
    </message>
    <message>
        <source>Run selected</source>
        <translation>Gewählte rechnen</translation>
    </message>
    <message>
        <source>Run all quick ones</source>
        <translation>Alle schnellen rechnen</translation>
    </message>
    <message>
        <source>All groups</source>
        <translation>Alle Gruppen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Lists this group alone, and runs it alone</source>
        <translation>Listet diese Gruppe allein auf und rechnet sie allein</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>running</source>
        <translation>rechnet</translation>
    </message>
    <message>
        <source>long; not run</source>
        <translation>lang; nicht gerechnet</translation>
    </message>
    <message>
        <source>not run</source>
        <translation>nicht gerechnet</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>Select a line first</source>
        <translation>Zuerst eine Zeile wählen</translation>
    </message>
    <message>
        <source>Export the results</source>
        <translation>Ergebnisse ausgeben</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>%1 cannot be written; choose another place</source>
        <translation>%1 kann nicht geschrieben werden; einen anderen Ort wählen</translation>
    </message>
</context>
<context>
    <name>talus::RunPanel</name>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Share of the run that is done</source>
        <translation>Erledigter Anteil des Laufs</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>%1 spent</source>
        <translation>%1 gebraucht</translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>noch nicht gerechnet</translation>
    </message>
    <message>
        <source>from results</source>
        <translation>aus Ergebnissen</translation>
    </message>
    <message>
        <source>Takes the run up where it was stopped, to the same numbers as if it had never been</source>
        <translation>Setzt den Lauf dort fort, wo er angehalten wurde, mit denselben Zahlen wie ohne Unterbrechung</translation>
    </message>
    <message>
        <source>Go on from %1 s</source>
        <translation>Weiter ab %1 s</translation>
    </message>
    <message>
        <source>Go on with the run</source>
        <translation>Lauf fortsetzen</translation>
    </message>
    <message>
        <source>goes on in the background</source>
        <translation>geht im Hintergrund weiter</translation>
    </message>
    <message>
        <source>at %1 s</source>
        <translation>bei %1 s</translation>
    </message>
    <message>
        <source>Stop ends it after its step</source>
        <translation>Anhalten beendet ihn nach seinem Schritt</translation>
    </message>
</context>
<context>
    <name>talus::RunProfile</name>
    <message>
        <source>Where the time of the run went</source>
        <translation>Wohin die Zeit des Laufs ging</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>find contacts</source>
        <translation>Kontakte finden</translation>
    </message>
    <message>
        <source>assemble</source>
        <translation>zusammensetzen</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>zerlegen</translation>
    </message>
    <message>
        <source>solve</source>
        <translation>lösen</translation>
    </message>
    <message>
        <source>update</source>
        <translation>nachführen</translation>
    </message>
    <message>
        <source>write</source>
        <translation>schreiben</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>Where the time went</source>
        <translation>Wohin die Zeit ging</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>of the run</source>
        <translation>des Laufs</translation>
    </message>
</context>
<context>
    <name>talus::SectionEditor</name>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show all of the profile (double click)</source>
        <translation>Das ganze Profil zeigen (Doppelklick)</translation>
    </message>
    <message>
        <source>Drag a corner, Shift snaps; click an edge for a new one; Delete takes one away.</source>
        <translation>Eine Ecke ziehen, Umschalt rastet ein; ein Klick auf eine Kante setzt eine neue; Entf nimmt eine weg.</translation>
    </message>
    <message>
        <source>change the profile of %1</source>
        <translation>Profil von %1 ändern</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
</context>
<context>
    <name>talus::SectionPlot</name>
    <message>
        <source>Profile of the section</source>
        <translation>Profil des Schnitts</translation>
    </message>
    <message>
        <source>distance d, m</source>
        <translation>Abstand d, m</translation>
    </message>
    <message>
        <source>height h, m</source>
        <translation>Höhe h, m</translation>
    </message>
</context>
<context>
    <name>talus::SeveralBlocks</name>
    <message>
        <source>Together</source>
        <translation>Zusammen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>%1 t</source>
        <translation>%1 t</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraeder</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>Werkstoffe</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>For all of them</source>
        <translation>Für alle</translation>
    </message>
    <message>
        <source>Excavate</source>
        <translation>Ausbrechen</translation>
    </message>
    <message>
        <source>Leaves them out: they are cut and taken away</source>
        <translation>Lässt sie aus: sie werden geschnitten und weggenommen</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>Zusammenfassen</translation>
    </message>
    <message>
        <source>Makes them one block; they must lie against each other</source>
        <translation>Macht sie zu einem Block; sie müssen aneinander liegen</translation>
    </message>
    <message>
        <source>their neighbours are not known yet</source>
        <translation>ihre Nachbarn sind noch nicht bekannt</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>gleich noch einmal versuchen</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>{n} becomes 1, 2, … in the order of the blocks; Enter gives the names</source>
        <translation>{n} wird 1, 2, … in der Reihenfolge der Blöcke; Eingabe gibt die Namen</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Verhalten</translation>
    </message>
    <message>
        <source>What the blocks may do: nothing, move, deform</source>
        <translation>Was die Blöcke dürfen: nichts, sich bewegen, sich verformen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation>Netzweite</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>wie sie ist</translation>
    </message>
    <message>
        <source>Edge length of the tetrahedra of these blocks</source>
        <translation>Kantenlänge der Tetraeder dieser Blöcke</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
</context>
<context>
    <name>talus::SlidePanel</name>
    <message>
        <source>Map of the deposit</source>
        <translation>Karte der Ablagerung</translation>
    </message>
    <message>
        <source>Velocity of the front</source>
        <translation>Geschwindigkeit der Front</translation>
    </message>
    <message>
        <source>Moved further than</source>
        <translation>Bewegt um mehr als</translation>
    </message>
    <message>
        <source>1 % of the model</source>
        <translation>1 % des Modells</translation>
    </message>
    <message>
        <source>Blocks whose centroid has gone further count as moved; empty: a hundredth of the diagonal of all blocks</source>
        <translation>Blöcke, deren Schwerpunkt weiter gekommen ist, gelten als bewegt; leer: ein Hundertstel der Diagonale aller Blöcke</translation>
    </message>
    <message>
        <source>Run-out and deposit</source>
        <translation>Reichweite und Ablagerung</translation>
    </message>
    <message>
        <source>Blocks that moved</source>
        <translation>Bewegte Blöcke</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Volume that moved</source>
        <translation>Bewegtes Volumen</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>straight down</source>
        <translation>senkrecht nach unten</translation>
    </message>
    <message>
        <source>Run-out of the front</source>
        <translation>Reichweite der Front</translation>
    </message>
    <message>
        <source>Farthest block</source>
        <translation>Weitester Block</translation>
    </message>
    <message>
        <source>… in plan</source>
        <translation>… im Grundriss</translation>
    </message>
    <message>
        <source>… forward</source>
        <translation>… vorwärts</translation>
    </message>
    <message>
        <source>Travel angle, crown to toe</source>
        <translation>Fahrböschung, Abrisskrone bis Fuß</translation>
    </message>
    <message>
        <source>Fall, length in plan</source>
        <translation>Fallhöhe, Länge im Grundriss</translation>
    </message>
    <message>
        <source>Angle of the centre&apos;s travel</source>
        <translation>Pauschalgefälle des Schwerpunkts</translation>
    </message>
    <message>
        <source>Area of the deposit</source>
        <translation>Fläche der Ablagerung</translation>
    </message>
    <message>
        <source>Volume with voids</source>
        <translation>Volumen mit Hohlräumen</translation>
    </message>
    <message>
        <source>Depth, at most</source>
        <translation>Mächtigkeit, höchstens</translation>
    </message>
    <message>
        <source>… on average</source>
        <translation>… im Mittel</translation>
    </message>
    <message>
        <source>Front at its fastest</source>
        <translation>Front am schnellsten</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <translation>%1 bei %2 s</translation>
    </message>
    <message>
        <source>Run-out and deposit are measured when a run has ended.</source>
        <translation>Reichweite und Ablagerung werden gemessen, wenn ein Lauf zu Ende ist.</translation>
    </message>
    <message>
        <source>Run-out and deposit are being measured.</source>
        <translation>Reichweite und Ablagerung werden gemessen.</translation>
    </message>
</context>
<context>
    <name>talus::SlippedJointsPanel</name>
    <message>
        <source>Net of the joints that slipped</source>
        <translation>Netz der geglittenen Klüfte</translation>
    </message>
    <message>
        <source>The frames are being looked at …</source>
        <translation>Die Bilder werden durchgesehen …</translation>
    </message>
    <message>
        <source>On which joints blocks slid is told of results on disk, when a run is over.</source>
        <translation>Auf welchen Klüften Blöcke glitten, wird von Ergebnissen auf der Platte gesagt, wenn eine Rechnung vorbei ist.</translation>
    </message>
    <message>
        <source>No block slid on another one that it lay against.</source>
        <translation>Kein Block glitt auf einem anderen, an dem er lag.</translation>
    </message>
</context>
<context>
    <name>talus::SolidTools</name>
    <message>
        <source>Import geometry…</source>
        <translation>Geometrie einlesen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>New box</source>
        <translation>Neuer Quader</translation>
    </message>
    <message>
        <source>add a box</source>
        <translation>Quader hinzufügen</translation>
    </message>
    <message>
        <source>New bench in section</source>
        <translation>Neue Berme im Schnitt</translation>
    </message>
    <message>
        <source>add a bench</source>
        <translation>Berme hinzufügen</translation>
    </message>
    <message>
        <source>New polyhedron</source>
        <translation>Neues Polyeder</translation>
    </message>
    <message>
        <source>add a polyhedron</source>
        <translation>Polyeder hinzufügen</translation>
    </message>
    <message>
        <source>New tunnel</source>
        <translation>Neuer Tunnel</translation>
    </message>
    <message>
        <source>add a tunnel</source>
        <translation>Tunnel hinzufügen</translation>
    </message>
    <message>
        <source>Edit section…</source>
        <translation>Schnitt bearbeiten…</translation>
    </message>
    <message>
        <source>Move solids…</source>
        <translation>Körper verschieben…</translation>
    </message>
    <message>
        <source>Turn solids…</source>
        <translation>Körper drehen…</translation>
    </message>
    <message>
        <source>Scale solids…</source>
        <translation>Körper skalieren…</translation>
    </message>
    <message>
        <source>Copy solids…</source>
        <translation>Körper kopieren…</translation>
    </message>
    <message>
        <source>Unite solids</source>
        <translation>Körper vereinigen</translation>
    </message>
    <message>
        <source>unite solids</source>
        <translation>Körper vereinigen</translation>
    </message>
    <message>
        <source>Subtract the last selected</source>
        <translation>Den zuletzt gewählten abziehen</translation>
    </message>
    <message>
        <source>subtract solids</source>
        <translation>Körper abziehen</translation>
    </message>
    <message>
        <source>Intersect solids</source>
        <translation>Körper schneiden</translation>
    </message>
    <message>
        <source>intersect solids</source>
        <translation>Körper schneiden</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>Öffnen Sie zuerst ein Projekt</translation>
    </message>
    <message>
        <source>Select a solid first</source>
        <translation>Wählen Sie zuerst einen Körper</translation>
    </message>
    <message>
        <source>Select two solids or more: Ctrl and a click adds one</source>
        <translation>Wählen Sie zwei Körper oder mehr: Strg und ein Klick fügt einen hinzu</translation>
    </message>
    <message>
        <source>Select a solid that is made of a section first</source>
        <translation>Wählen Sie zuerst einen Körper, der aus einem Schnitt gemacht ist</translation>
    </message>
    <message>
        <source>There is no rock yet</source>
        <translation>Noch ist kein Fels da</translation>
    </message>
    <message>
        <source>Import geometry</source>
        <translation>Geometrie einlesen</translation>
    </message>
    <message>
        <source>Geometry (*.step *.stp *.iges *.igs *.brep *.stl *.obj *.ply *.msh *.asc *.tif *.tiff *.xyz *.csv *.txt);;Solids (*.step *.stp *.iges *.igs *.brep *.stl *.obj *.ply *.msh);;Terrain (*.asc *.tif *.tiff *.xyz *.csv *.txt *.stl *.obj *.ply);;All files (*)</source>
        <translation>Geometrie (*.step *.stp *.iges *.igs *.brep *.stl *.obj *.ply *.msh *.asc *.tif *.tiff *.xyz *.csv *.txt);;Körper (*.step *.stp *.iges *.igs *.brep *.stl *.obj *.ply *.msh);;Gelände (*.asc *.tif *.tiff *.xyz *.csv *.txt *.stl *.obj *.ply);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>talus::SolidViewport</name>
    <message>
        <source>Preview of the solid</source>
        <translation>Vorschau des Körpers</translation>
    </message>
</context>
<context>
    <name>talus::SplinterList</name>
    <message>
        <source>leave splinters out</source>
        <translation>Splitter auslassen</translation>
    </message>
    <message>
        <source>merge splinters with their neighbours</source>
        <translation>Splitter mit Nachbarn verschmelzen</translation>
    </message>
    <message>
        <source>refuse splinters</source>
        <translation>Splitter ablehnen</translation>
    </message>
</context>
<context>
    <name>talus::SplinterPanel</name>
    <message>
        <source>Splinters</source>
        <translation>Splitter</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Lets the view go to the chosen one</source>
        <translation>Führt die Ansicht zum gewählten</translation>
    </message>
    <message>
        <source>Move the joint</source>
        <translation>Kluft verschieben</translation>
    </message>
    <message>
        <source>Selects the cut beside the chosen one, to be moved</source>
        <translation>Wählt den Schnitt neben dem gewählten, um ihn zu verschieben</translation>
    </message>
    <message>
        <source>Drop them</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Splinters are left out from now on; their volume is told</source>
        <translation>Splitter werden von nun an ausgelassen; ihr Volumen wird genannt</translation>
    </message>
    <message>
        <source>Merge with neighbours</source>
        <translation>Mit Nachbarn verschmelzen</translation>
    </message>
    <message>
        <source>Each becomes part of the block that it shares most of its surface with</source>
        <translation>Jeder wird Teil des Blocks, mit dem er am meisten Fläche teilt</translation>
    </message>
    <message>
        <source>The rock was not cut: %1 too thin to be blocks.</source>
        <translation>Der Fels wurde nicht geschnitten: %1 zu dünn für Blöcke.</translation>
    </message>
    <message>
        <source>%1, %2 m³ together</source>
        <translation>%1, zusammen %2 m³</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>What became of it</source>
        <translation>Was daraus wurde</translation>
    </message>
    <message>
        <source>Thickness m</source>
        <translation>Dicke m</translation>
    </message>
    <message>
        <source>Volume m³</source>
        <translation>Volumen m³</translation>
    </message>
    <message>
        <source>E m</source>
        <translation>O m</translation>
    </message>
    <message>
        <source>N m</source>
        <translation>N m</translation>
    </message>
    <message>
        <source>Z m</source>
        <translation>Z m</translation>
    </message>
</context>
<context>
    <name>talus::StageStrip</name>
    <message>
        <source>Stages in time</source>
        <translation>Abschnitte in der Zeit</translation>
    </message>
    <message>
        <source>%1: %2, %3; changes %4</source>
        <translation>%1: %2, %3; ändert %4</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>change the length of stage %1</source>
        <translation>Länge von Abschnitt %1 ändern</translation>
    </message>
    <message>
        <source>Drag the right edge to change its length, the stage to change the order</source>
        <translation>Den rechten Rand ziehen ändert die Länge, den Abschnitt ziehen die Reihenfolge</translation>
    </message>
    <message>
        <source>The project has no stage: there is nothing to solve.</source>
        <translation>Das Projekt hat keinen Abschnitt: es gibt nichts zu rechnen.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>+%1</source>
        <translation>+%1</translation>
    </message>
</context>
<context>
    <name>talus::StartPage</name>
    <message>
        <source>Rock slopes that come apart along joints</source>
        <translation>Felshänge, die entlang ihrer Klüfte auseinandergehen</translation>
    </message>
    <message>
        <source>Return to the project</source>
        <translation>Zurück zum Projekt</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>New…</source>
        <translation>Neu…</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open results…</source>
        <translation>Ergebnisse öffnen…</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>New from a template</source>
        <translation>Neu aus einer Vorlage</translation>
    </message>
    <message>
        <source>five numbers, a picture, a project</source>
        <translation>fünf Zahlen, ein Bild, ein Projekt</translation>
    </message>
    <message>
        <source>Empty project</source>
        <translation>Leeres Projekt</translation>
    </message>
    <message>
        <source>Nothing but gravity: everything else is yours to add</source>
        <translation>Nur Schwerkraft: alles andere fügen Sie hinzu</translation>
    </message>
    <message>
        <source>Samples with a known answer</source>
        <translation>Beispiele mit bekannter Antwort</translation>
    </message>
    <message>
        <source>opened as a copy: solve, compare, change</source>
        <translation>als Kopie geöffnet: rechnen, ändern, vergleichen</translation>
    </message>
    <message>
        <source>No samples were installed with the program.</source>
        <translation>Mit dem Programm wurden keine Beispiele installiert.</translation>
    </message>
    <message>
        <source>Forget %1</source>
        <translation>%1 vergessen</translation>
    </message>
    <message>
        <source>Files you open are listed here.</source>
        <translation>Dateien, die Sie öffnen, stehen hier.</translation>
    </message>
    <message>
        <source>Projects, results, files of geometry and tables of joints can be dropped anywhere.</source>
        <translation>Projekte, Ergebnisse, Geometriedateien und Klufttabellen können überall abgelegt werden.</translation>
    </message>
</context>
<context>
    <name>talus::StepFacts</name>
    <message>
        <source>t</source>
        <translation>t</translation>
    </message>
    <message>
        <source>Model time</source>
        <translation>Modellzeit</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Its number and length</source>
        <translation>Seine Nummer und Länge</translation>
    </message>
    <message>
        <source>Pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Wall time of a step, mean of the last %1</source>
        <translation>Dauer eines Schritts, Mittel der letzten %1</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>Open–close iterations of the step</source>
        <translation>Open–close-Iterationen des Schritts</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>Ruhend</translation>
    </message>
    <message>
        <source>Blocks at rest that are not computed</source>
        <translation>Blöcke in Ruhe, die nicht gerechnet werden</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Contact points of blocks that are awake, by state</source>
        <translation>Kontaktpunkte von Blöcken, die wach sind, nach Zustand</translation>
    </message>
    <message>
        <source>Penetration</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>Deepest of the step, over the local mesh size</source>
        <translation>Tiefste des Schritts, bezogen auf die örtliche Netzweite</translation>
    </message>
    <message>
        <source>Unbalanced</source>
        <translation>Ungleichgewicht</translation>
    </message>
    <message>
        <source>Norm of the force that is left out of balance at the end of the step</source>
        <translation>Norm der Kraft, die am Ende des Schritts nicht im Gleichgewicht ist</translation>
    </message>
    <message>
        <source>Time error</source>
        <translation>Zeitfehler</translation>
    </message>
    <message>
        <source>Estimated error of time integration in this step, over the smallest mesh size</source>
        <translation>Geschätzter Fehler der Zeitintegration in diesem Schritt, bezogen auf die kleinste Netzweite</translation>
    </message>
    <message>
        <source>Remainder</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Energy that the ledger misses, over the energy that has moved in the run</source>
        <translation>Energie, die in der Bilanz fehlt, bezogen auf die im Lauf umgesetzte</translation>
    </message>
    <message>
        <source>Numerical damping</source>
        <translation>Numerische Dämpfung</translation>
    </message>
    <message>
        <source>Energy that time integration has dissipated, over the energy that has moved</source>
        <translation>Energie, die die Zeitintegration verzehrt hat, bezogen auf die umgesetzte</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, Δt %2 ms</source>
        <translation>%1, Δt %2 ms</translation>
    </message>
    <message>
        <source>%1, not converged</source>
        <translation>%1, nicht konvergiert</translation>
    </message>
    <message>
        <source>%1 ms a step</source>
        <translation>%1 ms je Schritt</translation>
    </message>
    <message>
        <source>%1, step cut %2</source>
        <translation>%1, Schritt %2 gekürzt</translation>
    </message>
    <message>
        <source>no block</source>
        <translation>kein Block</translation>
    </message>
    <message>
        <source>%1 open, %2 stick, %3 slip</source>
        <translation>%1 offen, %2 haftend, %3 gleitend</translation>
    </message>
    <message>
        <source>%1 % of mesh size</source>
        <translation>%1 % der Netzweite</translation>
    </message>
    <message>
        <source>%1 kN</source>
        <translation>%1 kN</translation>
    </message>
    <message>
        <source>%1 % of energy</source>
        <translation>%1 % der Energie</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>Im Gange</translation>
    </message>
    <message>
        <source>The step that is being made: its open–close iterations so far, and the norm of the force that is out of balance</source>
        <translation>Der Schritt, der gerade gerechnet wird: seine Iterationen bisher und der Betrag der Kraft, die nicht im Gleichgewicht ist</translation>
    </message>
    <message>
        <source>iteration %1, %2 kN</source>
        <translation>Iteration %1, %2 kN</translation>
    </message>
</context>
<context>
    <name>talus::StereonetPanel</name>
    <message>
        <source>Stereonet</source>
        <translation>Lagenkugel</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>Scharen</translation>
    </message>
    <message>
        <source>95 % cone of the mean</source>
        <translation>95-%-Kegel des Mittels</translation>
    </message>
    <message>
        <source>Sets with their means</source>
        <translation>Scharen mit ihren Mitteln</translation>
    </message>
    <message>
        <source>Paste joints…</source>
        <translation>Klüfte einfügen…</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild sichern…</translation>
    </message>
    <message>
        <source>Net</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>lower hemisphere</source>
        <translation>untere Halbkugel</translation>
    </message>
    <message>
        <source>equal area</source>
        <translation>flächentreu</translation>
    </message>
    <message>
        <source>equal angle</source>
        <translation>winkeltreu</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Fisher, % per 1 % area</source>
        <translation>Fisher, % je 1 % Fläche</translation>
    </message>
    <message>
        <source>Kamb, σ</source>
        <translation>Kamb, σ</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>mean planes</source>
        <translation>mittlere Ebenen</translation>
    </message>
    <message>
        <source>Schmidt&apos;s net, for densities, or Wulff&apos;s, on which circles are circles</source>
        <translation>Schmidtsches Netz, für Dichten, oder Wulffsches, in dem Kreise Kreise sind</translation>
    </message>
    <message>
        <source>Great circles of the means of the sets</source>
        <translation>Großkreise der Mittel der Scharen</translation>
    </message>
    <message>
        <source>Contours of the density of poles</source>
        <translation>Linien gleicher Dichte der Pole</translation>
    </message>
    <message>
        <source>Give 0 to %1 degrees</source>
        <translation>0 bis %1 Grad angeben</translation>
    </message>
    <message>
        <source>Kinematic check</source>
        <translation>Kinematische Prüfung</translation>
    </message>
    <message>
        <source>Face dip</source>
        <translation>Fallen der Böschung</translation>
    </message>
    <message>
        <source>Face dip direction</source>
        <translation>Fallrichtung der Böschung</translation>
    </message>
    <message>
        <source>no face</source>
        <translation>keine Böschung</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Böschung</translation>
    </message>
    <message>
        <source>Dip and dip direction, clockwise from north</source>
        <translation>Fallen und Fallrichtung, im Uhrzeigersinn von Nord</translation>
    </message>
    <message>
        <source>Friction angle of the check</source>
        <translation>Reibungswinkel der Prüfung</translation>
    </message>
    <message>
        <source>φ of all joints in this check; it changes no joint of the project</source>
        <translation>φ aller Klüfte in dieser Prüfung; keine Kluft des Projekts wird geändert</translation>
    </message>
    <message>
        <source>Lateral limits</source>
        <translation>Seitliche Grenzen</translation>
    </message>
    <message>
        <source>How far a plane, or the direction of toppling, may be off the face&apos;s direction</source>
        <translation>Wie weit eine Ebene oder die Kipprichtung von der Richtung der Böschung abweichen darf</translation>
    </message>
    <message>
        <source>φ, limits ±</source>
        <translation>φ, Grenzen ±</translation>
    </message>
    <message>
        <source>Failure mode that is shown</source>
        <translation>Gezeigte Versagensart</translation>
    </message>
    <message>
        <source>Zone shown</source>
        <translation>Gezeigte Zone</translation>
    </message>
    <message>
        <source>Whose critical zone the net shows</source>
        <translation>Wessen kritische Zone das Netz zeigt</translation>
    </message>
    <message>
        <source>Give the face to see what can slide or topple in it.</source>
        <translation>Die Böschung angeben, um zu sehen, was in ihr gleiten oder kippen kann.</translation>
    </message>
    <message>
        <source>Critical poles and intersections</source>
        <translation>Kritische Pole und Schnittlinien</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>drag in the net; Shift: a cone</source>
        <translation>im Netz ziehen; Umschalt: ein Kegel</translation>
    </message>
    <message>
        <source>name of a joint set</source>
        <translation>Name einer Kluftschar</translation>
    </message>
    <message>
        <source>Name of the joint set</source>
        <translation>Name der Kluftschar</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuordnen</translation>
    </message>
    <message>
        <source>Gives the joints in the window to this set</source>
        <translation>Ordnet die Klüfte der Auswahl dieser Schar zu</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>The project has no joints yet: paste a table of them</source>
        <translation>Das Projekt hat noch keine Klüfte: eine Tabelle davon einfügen</translation>
    </message>
    <message>
        <source>, one for each plane</source>
        <translation>, einer je Ebene</translation>
    </message>
    <message>
        <source>, of the first %1 planes of a cut</source>
        <translation>, der ersten %1 Ebenen eines Schnitts</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Setzen</translation>
    </message>
    <message>
        <source>Poles</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>κ</source>
        <translation>κ</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>nicht gezählt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Planar sliding</source>
        <translation>Ebenes Gleiten</translation>
    </message>
    <message>
        <source>– without limits</source>
        <translation>– ohne Grenzen</translation>
    </message>
    <message>
        <source>Wedge sliding</source>
        <translation>Keilgleiten</translation>
    </message>
    <message>
        <source>– on one plane</source>
        <translation>– auf einer Ebene</translation>
    </message>
    <message>
        <source>Flexural toppling</source>
        <translation>Biegekippen</translation>
    </message>
    <message>
        <source>Direct toppling</source>
        <translation>Blockkippen</translation>
    </message>
    <message>
        <source>– oblique</source>
        <translation>– schräg</translation>
    </message>
    <message>
        <source>– base planes</source>
        <translation>– Grundflächen</translation>
    </message>
    <message>
        <source>Critical</source>
        <translation>Kritisch</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Intersections of more than %1 planes are not counted here</source>
        <translation>Schnittlinien von mehr als %1 Ebenen werden hier nicht gezählt</translation>
    </message>
    <message>
        <source>Picks a set of poles and tells its mean.</source>
        <translation>Wählt eine Schar von Polen und nennt ihr Mittel.</translation>
    </message>
    <message>
        <source>No pole in %1</source>
        <translation>Kein Pol in %1</translation>
    </message>
    <message>
        <source>%1 in %2
mean %3,  κ %4,  95 % cone %5</source>
        <translation>%1 in %2
Mittel %3,  κ %4,  95-%-Kegel %5</translation>
    </message>
    <message>
        <source>assign %1 to %2</source>
        <translation>%1 zu %2 zuordnen</translation>
    </message>
    <message>
        <source>Save the stereonet</source>
        <translation>Lagenkugel sichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Pick the face in the view</source>
        <translation>Die Fläche in der Ansicht wählen</translation>
    </message>
    <message>
        <source>Click the face in which blocks could fail</source>
        <translation>Klicken Sie die Fläche an, in der Blöcke versagen könnten</translation>
    </message>
    <message>
        <source>the face that was picked overhangs</source>
        <translation>die gewählte Fläche hängt über</translation>
    </message>
    <message>
        <source>pick a face that looks upwards, or type dip and dip direction</source>
        <translation>wählen Sie eine Fläche, die nach oben sieht, oder geben Sie Fallen und Fallrichtung ein</translation>
    </message>
</context>
<context>
    <name>talus::StereonetView</name>
    <message>
        <source>Stereonet: poles of the joints, lower hemisphere</source>
        <translation>Lagenkugel: Pole der Klüfte, untere Halbkugel</translation>
    </message>
    <message>
        <source>%1  %2
No. %3</source>
        <translation>%1  %2
Nr. %3</translation>
    </message>
</context>
<context>
    <name>talus::StudyStart</name>
    <message>
        <source>Share of the study that is done</source>
        <translation>Erledigter Anteil der Untersuchung</translation>
    </message>
    <message>
        <source>The study is of this project before it was changed.</source>
        <translation>Die Untersuchung gehört zu diesem Projekt, bevor es geändert wurde.</translation>
    </message>
    <message>
        <source>What accuracy costs is not known yet. A study solves the project under some twenty settings, from the cheapest to the finest, and tells error and seconds of each.</source>
        <translation>Was Genauigkeit kostet, ist noch nicht bekannt. Eine Untersuchung rechnet das Projekt unter etwa zwanzig Einstellungen, von der billigsten zur feinsten, und nennt Fehler und Sekunden jeder einzelnen.</translation>
    </message>
    <message>
        <source>Study again</source>
        <translation>Neu untersuchen</translation>
    </message>
    <message>
        <source>Study accuracy</source>
        <translation>Genauigkeit untersuchen</translation>
    </message>
    <message>
        <source>In the background; it takes many times as long as one run. What it has is kept when it is stopped</source>
        <translation>Im Hintergrund; es dauert vielmal so lang wie ein Lauf. Was fertig ist, bleibt erhalten, wenn man es anhält</translation>
    </message>
    <message>
        <source>%1; %2 left</source>
        <translation>%1; noch %2</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Runs that have ended are kept; the study can go on later</source>
        <translation>Läufe, die fertig sind, bleiben; die Untersuchung kann später weitergehen</translation>
    </message>
    <message>
        <source>What errors are of</source>
        <translation>Wovon die Fehler sind</translation>
    </message>
    <message>
        <source>Each from the finest run. No run is made again for another one</source>
        <translation>Jeder gegen den feinsten Lauf. Kein Lauf wird für einen anderen wiederholt</translation>
    </message>
    <message>
        <source>Runs of each setting</source>
        <translation>Läufe je Einstellung</translation>
    </message>
    <message>
        <source>Hardly changed from run to run: errors are of the means, and their scatter is told. Where blocks hit each other one run says little</source>
        <translation>Von Lauf zu Lauf kaum verändert: Fehler sind die der Mittel, und ihre Streuung wird gesagt. Wo Blöcke aufeinander stoßen, sagt ein Lauf wenig</translation>
    </message>
    <message>
        <source>Errors of</source>
        <translation>Fehler von</translation>
    </message>
    <message>
        <source>A whole number from %1 to %2</source>
        <translation>Eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>More runs of each setting, or errors of something else:</source>
        <translation>Mehr Läufe je Einstellung, oder Fehler von etwas anderem:</translation>
    </message>
    <message>
        <source>The study was stopped before all of its runs had ended.</source>
        <translation>Die Studie wurde angehalten, bevor alle ihre Läufe zu Ende waren.</translation>
    </message>
    <message>
        <source>Study further</source>
        <translation>Weiter untersuchen</translation>
    </message>
</context>
<context>
    <name>talus::TableField</name>
    <message>
        <source>%1 rows: too many for a table</source>
        <translation>%1 Zeilen: zu viele für eine Tabelle</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Add a row behind the one with the cursor</source>
        <translation>Eine Zeile hinter der mit dem Cursor hinzufügen</translation>
    </message>
    <message>
        <source>Take the row with the cursor away</source>
        <translation>Die Zeile mit dem Cursor wegnehmen</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Replace all rows by those of the clipboard, copied from a spreadsheet or text</source>
        <translation>Alle Zeilen durch die der Zwischenablage ersetzen, aus Tabellenkalkulation oder Text kopiert</translation>
    </message>
    <message>
        <source>row %1: %2; %3</source>
        <translation>Zeile %1: %2; %3</translation>
    </message>
    <message>
        <source>line %1 of what was copied has %2 numbers; %3 are wanted</source>
        <translation>Zeile %1 des Kopierten hat %2 Zahlen; %3 sind nötig</translation>
    </message>
    <message>
        <source>line %1 of what was copied: %2</source>
        <translation>Zeile %1 des Kopierten: %2</translation>
    </message>
    <message>
        <source>nothing was copied that is a table of numbers</source>
        <translation>es wurde nichts kopiert, das eine Tabelle von Zahlen ist</translation>
    </message>
</context>
<context>
    <name>talus::TemplateForm</name>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>talus::TextField</name>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
</context>
<context>
    <name>talus::Timeline</name>
    <message>
        <source>Previous frame (Left)</source>
        <translation>Voriges Bild (Links)</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>Next frame (Right)</source>
        <translation>Nächstes Bild (Rechts)</translation>
    </message>
    <message>
        <source>Loop (L)</source>
        <translation>Wiederholen (L)</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>1× real</source>
        <translation>1× Echtzeit</translation>
    </message>
    <message>
        <source>Speed of play</source>
        <translation>Abspielgeschwindigkeit</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>of %1 s</source>
        <translation>von %1 s</translation>
    </message>
    <message>
        <source>no frames yet</source>
        <translation>noch keine Bilder</translation>
    </message>
    <message>
        <source>Model time a second of watching</source>
        <translation>Modellzeit je Sekunde des Zuschauens</translation>
    </message>
</context>
<context>
    <name>talus::TimelineTrack</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
</context>
<context>
    <name>talus::TopBar</name>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Light or dark (Ctrl+Shift+D)</source>
        <translation>Hell oder dunkel (Strg+Umschalt+D)</translation>
    </message>
    <message>
        <source>has no file</source>
        <translation>hat keine Datei</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gesichert</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gesichert</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>geändert</translation>
    </message>
</context>
<context>
    <name>talus::TrialPage</name>
    <message>
        <source>not run yet</source>
        <translation>noch nicht gerechnet</translation>
    </message>
    <message>
        <source>holds, %1</source>
        <translation>hält, %1</translation>
    </message>
    <message>
        <source>does not hold, %1</source>
        <translation>hält nicht, %1</translation>
    </message>
    <message>
        <source>falls short, known, %1</source>
        <translation>bleibt zurück, bekannt, %1</translation>
    </message>
    <message>
        <source>Must come to: %1</source>
        <translation>Muss ergeben: %1</translation>
    </message>
    <message>
        <source>Known to fall short: %1</source>
        <translation>Bekannt, dass es zurückbleibt: %1</translation>
    </message>
    <message>
        <source>Group: %1</source>
        <translation>Gruppe: %1</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>This case takes minutes.</source>
        <translation>Dieser Fall dauert Minuten.</translation>
    </message>
    <message>
        <source>Again on %1: the same bits</source>
        <translation>Noch einmal auf %1: bitgleich</translation>
    </message>
    <message>
        <source>What no case may break</source>
        <translation>Was kein Fall brechen darf</translation>
    </message>
    <message>
        <source>Came to</source>
        <translation>Ergab</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Unter</translation>
    </message>
    <message>
        <source>Deepest contact, of the mesh size</source>
        <translation>Tiefster Kontakt, der Netzweite</translation>
    </message>
    <message>
        <source>Interpenetration of blocks, of the mesh size</source>
        <translation>Durchdringung von Blöcken, der Netzweite</translation>
    </message>
    <message>
        <source>Growth of energy, of what moved</source>
        <translation>Energiezuwachs, des Umgesetzten</translation>
    </message>
    <message>
        <source>Least volume of a tetrahedron, of that at the start</source>
        <translation>Kleinstes Volumen eines Tetraeders, des anfänglichen</translation>
    </message>
    <message>
        <source>above 0</source>
        <translation>über 0</translation>
    </message>
</context>
<context>
    <name>talus::TroublePanel</name>
    <message>
        <source>Convergence trouble so far</source>
        <translation>Konvergenzprobleme bisher</translation>
    </message>
    <message>
        <source>Convergence trouble</source>
        <translation>Konvergenzprobleme</translation>
    </message>
</context>
<context>
    <name>talus::TroubleRow</name>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Turns the view to the place and selects its blocks</source>
        <translation>Dreht die Ansicht zu der Stelle und wählt ihre Blöcke</translation>
    </message>
</context>
<context>
    <name>talus::TypicalStrengths</name>
    <message>
        <source>Typical strength</source>
        <translation>Übliche Festigkeit</translation>
    </message>
    <message>
        <source>own values</source>
        <translation>eigene Werte</translation>
    </message>
    <message>
        <source>Values that others have measured, to begin with</source>
        <translation>Werte, die andere gemessen haben, für den Anfang</translation>
    </message>
    <message>
        <source>typical; measured: %1
%2</source>
        <translation>üblich; gemessen: %1
%2</translation>
    </message>
    <message>
        <source>Typical</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source>use %1 for %2</source>
        <translation>%1 für %2 nehmen</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Typical stiffness</source>
        <translation>Übliche Steifigkeit</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>selbsttätig</translation>
    </message>
</context>
<context>
    <name>talus::UnitsButton</name>
    <message>
        <source>In which units numbers are shown. Any other can be typed: 50 kPa, 2.7 t/m³, 0.5 rad</source>
        <translation>In welchen Einheiten Zahlen gezeigt werden. Jede andere kann eingegeben werden: 50 kPa, 2.7 t/m³, 0.5 rad</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>as usual for each</source>
        <translation>wie üblich für jede</translation>
    </message>
</context>
<context>
    <name>talus::VectorDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Create</source>
        <translation>Anlegen</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Pressure on the face</source>
        <translation>Druck auf die Fläche</translation>
    </message>
    <message>
        <source>Said as</source>
        <translation>Angegeben als</translation>
    </message>
    <message>
        <source>The resultant itself, or a pressure that is multiplied by the face&apos;s area</source>
        <translation>Die Resultierende selbst oder ein Druck, der mit der Fläche malgenommen wird</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>How large it is, in %1 or any other unit of its kind</source>
        <translation>Wie groß, in %1 oder jeder anderen Einheit dieser Art</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>Force per area of the face, in kPa or any other unit of stress</source>
        <translation>Kraft je Fläche, in kPa oder jeder anderen Spannungseinheit</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Abwärts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Aufwärts</translation>
    </message>
    <message>
        <source>By trend and plunge</source>
        <translation>Nach Richtung und Neigung</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Into the face</source>
        <translation>In die Fläche hinein</translation>
    </message>
    <message>
        <source>Out of the face</source>
        <translation>Aus der Fläche heraus</translation>
    </message>
    <message>
        <source>Which way it goes</source>
        <translation>Wohin es geht</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction on the map, degrees clockwise from north</source>
        <translation>Richtung auf der Karte, Grad im Uhrzeigersinn von Nord</translation>
    </message>
    <message>
        <source>Plunge</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Angle below the horizontal, degrees; negative: upwards</source>
        <translation>Winkel unter der Waagrechten, Grad; negativ: aufwärts</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3</source>
        <translation>x %1, y %2, z %3</translation>
    </message>
    <message>
        <source>%1 on %2 m²: </source>
        <translation>%1 auf %2 m²: </translation>
    </message>
</context>
<context>
    <name>talus::VectorField</name>
    <message>
        <source>Pick it in the view</source>
        <translation>In der Ansicht zeigen</translation>
    </message>
    <message>
        <source>Click the place of: %1</source>
        <translation>Auf die Stelle klicken: %1</translation>
    </message>
    <message>
        <source>pick %1 of %2</source>
        <translation>%1 von %2 zeigen</translation>
    </message>
</context>
<context>
    <name>talus::Verification</name>
    <message>
        <source>Known answers and hard cases</source>
        <translation>Bekannte Antworten und schwere Fälle</translation>
    </message>
    <message>
        <source>Known answers</source>
        <translation>Bekannte Antworten</translation>
    </message>
    <message>
        <source>Hard cases</source>
        <translation>Schwere Fälle</translation>
    </message>
</context>
<context>
    <name>talus::Viewport</name>
    <message>
        <source>3-D view</source>
        <translation>3-D-Ansicht</translation>
    </message>
    <message>
        <source>Cut and mesh</source>
        <translation>Schneiden und vernetzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The blocks stay as they were before; it can be begun again</source>
        <translation>Die Blöcke bleiben, wie sie vorher waren; es kann neu begonnen werden</translation>
    </message>
    <message>
        <source>There are no blocks yet: cut the rock along its joints and mesh it to see them.</source>
        <translation>Es gibt noch keine Blöcke: den Fels entlang seiner Klüfte schneiden und vernetzen, um sie zu sehen.</translation>
    </message>
    <message>
        <source>E %1  N %2  Z %3 m</source>
        <translation>O %1  N %2  Z %3 m</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Divides the rock along its cuts into blocks and meshes each (F4)</source>
        <translation>Teilt den Fels entlang seiner Schnitte in Blöcke und vernetzt jeden (F4)</translation>
    </message>
    <message>
        <source>Cutting and meshing, %1 %</source>
        <translation>Schneidet und vernetzt, %1 %</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>Reading the solids …</source>
        <translation>Körper werden gelesen …</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
    <message>
        <source>Import geometry…</source>
        <translation>Geometrie einlesen…</translation>
    </message>
    <message>
        <source>There is no rock yet: import geometry, or make a new solid.</source>
        <translation>Es gibt noch keinen Fels: Geometrie einlesen oder einen neuen Körper anlegen.</translation>
    </message>
    <message>
        <source>Solids and terrain from a file, shown before they are taken</source>
        <translation>Körper und Gelände aus einer Datei, gezeigt, bevor sie übernommen werden</translation>
    </message>
    <message>
        <source>Face on joint %1</source>
        <translation>Fläche auf Kluft %1</translation>
    </message>
    <message>
        <source>Face on no joint</source>
        <translation>Fläche auf keiner Kluft</translation>
    </message>
    <message>
        <source>Element %1, node %2</source>
        <translation>Element %1, Knoten %2</translation>
    </message>
    <message>
        <source>%1 selected: %2 m³</source>
        <translation>%1 gewählt: %2 m³</translation>
    </message>
</context>
<context>
    <name>talus::WindowActions</name>
    <message>
        <source>New…</source>
        <translation>Neu…</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open results…</source>
        <translation>Ergebnisse öffnen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Sichern unter…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild sichern…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+P</source>
        <translation>Ctrl+Shift+P</translation>
    </message>
    <message>
        <source>Save film…</source>
        <translation>Film sichern…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Clear selection</source>
        <translation>Auswahl aufheben</translation>
    </message>
    <message>
        <source>Fit all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>From the south-west</source>
        <translation>Von Südwesten</translation>
    </message>
    <message>
        <source>From the south</source>
        <translation>Von Süden</translation>
    </message>
    <message>
        <source>From the east</source>
        <translation>Von Osten</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>Perspective or parallel</source>
        <translation>Perspektivisch oder parallel</translation>
    </message>
    <message>
        <source>Show all blocks</source>
        <translation>Alle Blöcke zeigen</translation>
    </message>
    <message>
        <source>Draw blocks apart</source>
        <translation>Blöcke auseinander zeichnen</translation>
    </message>
    <message>
        <source>Show loads, supports and monitors</source>
        <translation>Lasten, Lager und Messpunkte zeigen</translation>
    </message>
    <message>
        <source>Light or dark</source>
        <translation>Hell oder dunkel</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>The view alone</source>
        <translation>Die Ansicht allein</translation>
    </message>
    <message>
        <source>Ctrl+%1</source>
        <translation>Ctrl+%1</translation>
    </message>
    <message>
        <source>Stereonet…</source>
        <translation>Lagenkugel…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Paste joints…</source>
        <translation>Klüfte einfügen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Cut and mesh</source>
        <translation>Schneiden und vernetzen</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Innehalten</translation>
    </message>
    <message>
        <source>One step</source>
        <translation>Ein Schritt</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Shift+F5</source>
        <translation>Shift+F5</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Voriges Bild</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Ctrl+Home</source>
        <translation>Ctrl+Home</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>Ctrl+End</source>
        <translation>Ctrl+End</translation>
    </message>
    <message>
        <source>Accuracy…</source>
        <translation>Genauigkeit…</translation>
    </message>
    <message>
        <source>Known answers…</source>
        <translation>Bekannte Antworten…</translation>
    </message>
    <message>
        <source>Hard cases…</source>
        <translation>Schwere Fälle…</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>About Talus</source>
        <translation>Über Talus</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Loads and supports</source>
        <translation>Lasten und Lager</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Open a project first</source>
        <translation>Zuerst ein Projekt öffnen</translation>
    </message>
    <message>
        <source>Nothing has been solved yet</source>
        <translation>Noch ist nichts gerechnet</translation>
    </message>
    <message>
        <source>Nothing runs</source>
        <translation>Es läuft nichts</translation>
    </message>
    <message>
        <source>A run goes on: stop it first</source>
        <translation>Ein Lauf ist im Gange: zuerst anhalten</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>Seit dem Sichern hat sich nichts geändert</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Hide what is selected</source>
        <translation>Gewähltes verbergen</translation>
    </message>
    <message>
        <source>Show what is selected alone</source>
        <translation>Gewähltes allein zeigen</translation>
    </message>
    <message>
        <source>Show joints</source>
        <translation>Klüfte zeigen</translation>
    </message>
    <message>
        <source>There is no rock yet</source>
        <translation>Es gibt noch kein Gestein</translation>
    </message>
    <message>
        <source>Select a block or a solid first</source>
        <translation>Zuerst einen Block oder Körper wählen</translation>
    </message>
    <message>
        <source>New solid</source>
        <translation>Neuer Körper</translation>
    </message>
    <message>
        <source>Change solids</source>
        <translation>Körper ändern</translation>
    </message>
    <message>
        <source>Cut open across the view</source>
        <translation>Quer zur Ansicht aufschneiden</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>Bericht speichern…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
    <message>
        <source>Export tables (CSV)…</source>
        <translation>Tabellen ausgeben (CSV)…</translation>
    </message>
    <message>
        <source>Export for ParaView (VTU)…</source>
        <translation>Für ParaView ausgeben (VTU)…</translation>
    </message>
    <message>
        <source>Export this frame (STL)…</source>
        <translation>Dieses Bild ausgeben (STL)…</translation>
    </message>
    <message>
        <source>Export for the web (glTF)…</source>
        <translation>Für das Web ausgeben (glTF)…</translation>
    </message>
    <message>
        <source>The run goes on: its results are complete at its end</source>
        <translation>Der Lauf geht weiter: seine Ergebnisse sind erst am Ende vollständig</translation>
    </message>
    <message>
        <source>Go on with the run</source>
        <translation>Lauf fortsetzen</translation>
    </message>
    <message>
        <source>No run of this project was stopped that could go on</source>
        <translation>Kein Lauf dieses Projekts wurde angehalten, der weitergehen könnte</translation>
    </message>
    <message>
        <source>Save view…</source>
        <translation>Ansicht speichern…</translation>
    </message>
    <message>
        <source>Open view…</source>
        <translation>Ansicht öffnen…</translation>
    </message>
    <message>
        <source>Compare with results…</source>
        <translation>Mit Ergebnissen vergleichen …</translation>
    </message>
</context>
<context>
    <name>talus::WorkflowBar</name>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>A force on a point, a face or a block that is picked in the view</source>
        <translation>Eine Kraft auf einen Punkt, eine Fläche oder einen Block, in der Ansicht gezeigt</translation>
    </message>
    <message>
        <source>Support</source>
        <translation>Lager</translation>
    </message>
    <message>
        <source>A point, a face or a block that is held, picked in the view</source>
        <translation>Ein Punkt, eine Fläche oder ein Block, der festgehalten wird, in der Ansicht gezeigt</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>A point whose history is recorded, picked in the view</source>
        <translation>Ein Punkt, dessen Verlauf aufgezeichnet wird, in der Ansicht gezeigt</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>edited since; %1</source>
        <translation>seither geändert; %1</translation>
    </message>
    <message>
        <source>Cutting and meshing</source>
        <translation>Schneidet und vernetzt</translation>
    </message>
    <message>
        <source>Stopping after this step</source>
        <translation>Hält nach diesem Schritt an</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Hält an</translation>
    </message>
    <message>
        <source>Stage %1 of %2: %3</source>
        <translation>Abschnitt %1 von %2: %3</translation>
    </message>
    <message>
        <source>   paused</source>
        <translation>   hält inne</translation>
    </message>
    <message>
        <source>   %1 left</source>
        <translation>   noch %1</translation>
    </message>
    <message>
        <source>%1, before the last change</source>
        <translation>%1, vor der letzten Änderung</translation>
    </message>
    <message>
        <source>not cut yet</source>
        <translation>noch nicht geschnitten</translation>
    </message>
    <message>
        <source>not meshed yet</source>
        <translation>noch nicht vernetzt</translation>
    </message>
    <message>
        <source>%1 tetrahedra, %2 nodes</source>
        <translation>%1 Tetraeder, %2 Knoten</translation>
    </message>
    <message>
        <source>gravity %1 m/s², %2, %3</source>
        <translation>Schwerkraft %1 m/s², %2, %3</translation>
    </message>
    <message>
        <source>%1, %2 s</source>
        <translation>%1, %2 s</translation>
    </message>
    <message>
        <source>nothing has been solved yet</source>
        <translation>noch ist nichts gerechnet</translation>
    </message>
    <message>
        <source>%1, of the project before it was edited</source>
        <translation>%1, des Projekts vor der Änderung</translation>
    </message>
    <message>
        <source>Go to solve</source>
        <translation>Zum Rechnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cutting and meshing, %1 left</source>
        <translation>Schneidet und vernetzt, noch %1</translation>
    </message>
    <message>
        <source>%1, %2 m³ of %3 m³</source>
        <translation>%1, %2 m³ von %3 m³</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>New solid</source>
        <translation>Neuer Körper</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Move, turn, scale, copy or combine the selected solids</source>
        <translation>Die gewählten Körper verschieben, drehen, skalieren, kopieren oder verbinden</translation>
    </message>
    <message>
        <source>%1, being read</source>
        <translation>%1, wird gelesen</translation>
    </message>
    <message>
        <source>%1; %2: %3</source>
        <translation>%1; %2: %3</translation>
    </message>
    <message>
        <source>%1, %2 m³</source>
        <translation>%1, %2 m³</translation>
    </message>
    <message>
        <source>In the background: %1 s</source>
        <translation>Im Hintergrund: %1 s</translation>
    </message>
</context>
</TS>
