// The pit wall of samples/step_slope: two 40 m benches with faces of 65 degrees, curved in plan as an open pit's are.
// x east (out of the wall), y north, z up, metres. Make the STEP file with
//   gmsh tools/step_slope.geo -0 -format step -o samples/step_slope/slope.step
//   sed -i 's/SI_UNIT(.MILLI.,.METRE.)/SI_UNIT($,.METRE.)/' samples/step_slope/slope.step
// (gmsh writes its numbers as millimetres; they are metres here).
SetFactory("OpenCASCADE");

toe = 160;                    // radius of the pit at the toe, m
berm = 8;                     // width of the berm between the benches, m
back = 40 / Tan(65 * Pi / 180);  // how far a face leans back over 40 m

Box(1) = {0, 0, 0, 160, 120, 100};
Cone(2) = {260, 60, 20, 0, 0, 40, toe, toe + back};
Cone(3) = {260, 60, 60, 0, 0, 40, toe + back + berm, toe + 2 * back + berm};
BooleanDifference { Volume{1}; Delete; }{ Volume{2, 3}; Delete; }
