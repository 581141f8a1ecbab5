#pragma once

namespace talus {

// What decides how a step is solved. h is the mesh size of a contact or of a body's blocks. Of each value it is said
// what it is measured in ("–": a pure number), what it decides, where it comes from ("chosen": nothing calls for just
// this number), and what becomes of results when it is larger or smaller. Each class of core/solve and core/effects
// takes its own group.

/// How long the steps of a stage are, and how far contacts are sought.
struct StepTolerances {
  /// –. A step that does not converge is cut by this factor, and the next ones grow back by it. Chosen. Larger: fewer
  /// trials, shorter steps than needed.
  double cut_factor = 3;
  /// Of the stage's time_step. No step is cut below it: then the run has not converged. Chosen. Smaller: hard places
  /// are tried longer before the run gives up.
  double shortest_step = 0.01;
  /// Of the smallest h. … unless a node still goes further than this in it: a body that flies by many of its own sizes
  /// a step is stopped by a wall in a small part of it. Chosen. Smaller: as above.
  double shortest_way = 0.01;
  /// –. Contacts of two bodies are sought within this many times what they go against each other in the step. Chosen:
  /// forces speed them up. Larger: more points that bear nothing. Smaller: missed contacts.
  double reach_factor = 2.5;
  /// Of the smallest h. Added to the reach, so that touching faces are found at rest. Chosen. As above.
  double least_reach = 1e-3;
  /// Rounds in which a converged step is corrected (normals, stiffness, multipliers, accelerations) and converged
  /// again. Chosen: each round of the augmented Lagrangian divides penetration by about the ratio of contact to rock
  /// stiffness, so three or four suffice; normals of contacts that turn fast settle in ten. Dynamic steps that need
  /// more are cut. Smaller: contacts stay deeper than asked, and steps are cut. Reaching it is counted in the report.
  int correction_limit = 20;
  /// Of the forces on each body. A step is corrected as soon as no body is further out of balance than this, and goes
  /// on to its tolerance when nothing is left to correct. Chosen. Larger: what small forces do is not seen yet.
  /// Smaller: more iterations on contacts that are changed anyway.
  double corrected_residual = 1e-3;
  /// Of h. Springs of contacts whose stiffness nobody has given give by no more, where the project has no
  /// penetration_tolerance. Chosen: a quarter of what published bodies keep apart, for what takes a contact over may be
  /// found twice as deep. Where the project's tolerance is larger, that tolerance is it. Larger: softer contacts,
  /// deeper. Smaller: more corrections and stiffer contacts.
  double penetration = 2.5e-4;
  /// Of the shortest part that a step is cut to. A shorter one is accepted even if it misses a contact. Chosen: three
  /// cuts. Larger: missed contacts go deeper. Smaller: more cuts.
  double shortest_recheck = 3;
  /// Steps of a static stage before it may end in equilibrium. Two, as the first starts from a state without any
  /// inertia force to measure. Larger: longer static stages.
  int fewest_static_steps = 2;
  /// Of the length of a step. What is left of a step after its parts is rounding. Larger: time is lost.
  double time_rounding = 1e-9;
  /// Steps of the stage's time_step. Blocks that cannot meet in so many are alone: for them no contact is looked for
  /// until then, or until one has gone farther than was foreseen. Chosen. Larger: fewer blocks are alone. Smaller: who
  /// is alone is asked more often.
  int foreseen_steps = 500;
  /// –. What a block may go by then is so many times what gravity, loads and its speed take it. Chosen: blocks that are
  /// struck go on faster. Larger: fewer are alone. Smaller: who is alone is asked more often.
  double foreseen_way = 2;
};

/// When the open–close iteration of a step has converged, and when it changes its method.
struct ConvergenceTolerances {
  /// Residual over the largest force, in dynamic steps. Chosen: two digits below the energy that a run may gain or lose
  /// unseen. Larger: the energy ledger does not close. Smaller: more iterations, up to rounding.
  double dynamic_residual = 1e-10;
  /// The same of static steps, in which forces hardly do any work. As above.
  double static_residual = 1e-11;
  /// Residual over the largest force. A residual that is below this and no longer falls is rounding, and has converged.
  /// Chosen from runs with stiff contacts. Larger: steps end early. Smaller: steps whose rounding is larger are cut.
  double rounding_residual = 1e-9;
  /// – (fraction), iterations. A residual that has not come down to this fraction in so many iterations no longer
  /// falls. Chosen. Smaller, fewer: rounding is seen sooner, and slow convergence is taken for it.
  double stalled_fraction = 0.5;
  int stalled_iterations = 2;
  /// –. A residual below this many roundings of a deformation times the stiffness is rounding, too. Chosen. As above.
  double rounding_factor = 4;
  /// Of the largest elastic force. This much of it counts when the residual's scale is taken. Internal forces of
  /// stressed rock cancel: their rounding must not count as a residual, nor may their size hide one. Chosen. Larger:
  /// small residuals between stressed blocks pass. Smaller: rounding never converges.
  double elastic_force_weight = 1e-3;
  /// Of the force that stops a body within the step. The same for the change of momentum in free flight. Chosen. As
  /// above.
  double momentum_force_weight = 1e-6;
  /// Of the residual at which a step has converged. Independent systems whose residuals are together below it are not
  /// solved. Chosen. Larger: residuals of many systems add up to more than allowed. Smaller: blocks at rest are solved.
  double negligible_system = 0.1;

  /// Of the project's tolerance. Where bodies are balanced each alone to a tolerance larger than that of reference, the
  /// work of what is left may be no more than this of it, of the works of all effects. Chosen: at standard the energy
  /// ledger then closes as at reference, to 1e-8. Larger: it does not. Smaller: more iterations.
  double work_of_residual = 1e-3;

  /// Of h. The first iteration takes contacts that are open by less as closed and sticking: a block that is only just
  /// set down has no contact force yet, and a tangent without its contacts would send it through the ground. Chosen,
  /// above rounding. Larger: open contacts hold for an iteration. Smaller: more iterations after landing.
  double first_closing = 2e-7;
  /// Of the strength. Rounds that hold the states of contacts, but for the last one, end where friction is by no more
  /// another than what the round bore. Chosen. Larger: friction is that of other normal forces, and of another
  /// direction. Smaller: more rounds.
  double friction_settled = 1e-3;

  /// Iterations after which a step is hard, and listed as trouble; most take two to six. A static stage that has had
  /// such a step goes on with springs that its steps can follow. Chosen. Larger: static stages of crowds stay slow for
  /// longer. Smaller: contacts that do not need it get softer, and sink by up to the allowed penetration.
  int hard_step = 25;
  /// Newton iterations since the residual last came down to `stalled_fraction`, after which the interior-point method
  /// begins anew. Chosen from the hard cases and from pours, as are the next three. Larger: circles are left later.
  /// Smaller: quick steps take the slow way.
  int newton_iterations = 6;
  /// The first iterations, which may close contacts together. Later ones mostly go round in circles.
  int closing_iterations = 2;
  /// Unknowns up to which it tries: its factors are those of an unsymmetric matrix. Larger: more memory and time.
  int interior_point_unknowns = 20000;
  /// Iterations that it may take.
  int interior_point_limit = 50;
  /// Residual over the largest force, at which it leaves the rest to Newton's method. Chosen. Larger: the guess is
  /// worse. Smaller: more dear iterations.
  double interior_point_residual = 1e-4;
  /// The same: if it leaves more, with more contacts than iterations left, the step is cut. Frozen friction tells
  /// contacts apart one by one. Chosen. Larger: time is spent in vain. Smaller: steps are cut that might converge.
  double hopeless_residual = 0.05;

  /// – (fraction). A full Newton increment that leaves less of the residual needs no line search. Chosen. Larger:
  /// slower convergence is put up with. Smaller: more searches.
  double reduced = 0.9;
  /// – (fraction). Nor does one that turns the slope of the potential round by no more. Chosen. As above.
  double slope_turned = 0.5;
  /// Of the residual of all bodies. Nor do bodies that are left with less: a direction is no more exact. Chosen.
  double negligible_part = 1e-3;
  /// – (fraction). With frozen friction, a coupled iteration is kept if it leaves less of the residual. Chosen.
  double well_reduced = 0.3;
  /// – (fraction). Friction strengths stay frozen until so much of the residual is left that there was when they were
  /// taken. Chosen. Larger: more changes of strength. Smaller: more iterations at a strength that changes anyway.
  double frozen_reduction = 0.01;
  /// Trials for the minimum of the potential along an increment that has overshot it. Smaller: searches end early.
  int line_search_limit = 20;
  /// – (fraction). A full increment after which the slope has turned round by more is shortened … Chosen.
  double overshot = 0.5;
  /// – (fraction). … until the slope is down to this. Chosen. Larger: searches end early. Smaller: more trials.
  double flat_slope = 0.1;

  /// –. Relative residual at which GMRES stops. Chosen: Newton's method gains four digits an iteration. Larger: more
  /// iterations of it, smaller: of GMRES.
  double gmres = 1e-4;
  /// Iterations of GMRES after which the matrix is factored anew. Chosen. Time alone hangs on it, and the last digits.
  int gmres_limit = 40;
  /// Iterations of GMRES with an incomplete factor after which a system gets a whole one. Chosen: slopes of rigid
  /// blocks take 10 to 20. Time alone hangs on it, and the last digits.
  int incomplete_limit = 40;
};

/// Bodies that are balanced by themselves.
struct EliminationTolerances {
  /// Of the forces on a body. One of which more is out of balance after an iteration is balanced by itself … Chosen: a
  /// slope of 710 blocks takes 272 iterations in 20 steps with a hundredth. Larger: what is hard stays in. Smaller: few
  /// iterations leave few enough.
  double unbalanced = 1e-2;
  /// Of the bodies that move. … unless there are more of them. Chosen: meshed slopes of some 300 blocks take 56 and 40
  /// iterations in four steps with 0.6, 91 and 49 with 0.3, 153 and far more with 0.05; rigid ones 4 to 13 % fewer.
  /// Larger: hardly anything is held. Smaller: what is hard stays in.
  double most_bodies = 0.5;
  /// Of the bodies that move. Those that a correction leaves far out of balance are balanced by themselves, and
  /// corrected again, before all go on, unless there are more. Chosen. Larger: an iteration on them costs nearly as
  /// much as one on all. Smaller: all go on after each correction.
  double few_bodies = 0.1;
  /// Iterations that they may take. Chosen: most take two to five. Smaller: what is hard stays in.
  int iterations = 30;
  /// The same where an increment is kept if they come into balance. Chosen: with 30, slopes take as many iterations, a
  /// pour of 200 blocks half as many again. Smaller: increments are shortened for bodies that could be balanced.
  int iterations_on_way = 10;
};

/// Which guess an iteration begins with.
struct FirstGuessTolerances {
  /// – (fraction). A static step goes on as the last one did only where that leaves less than this of the residual at
  /// rest, where bodies creep steadily. Chosen. Larger: a step may be led past the strength of contacts that would
  /// hold: a wedge between joints that dilate has a second equilibrium there, sliding. Smaller: more iterations.
  double creeping = 0.01;
  /// – (fraction). A guess is better if it leaves less than this. Rounding. Larger: rounding chooses and keeps blocks
  /// awake.
  double better = 1 - 1e-6;
  /// – (fraction). The same where the residual may be rounding of positions. Chosen. Larger: going on as before stirs
  /// the rounding, and blocks at rest are solved for ever.
  double clearly_better = 0.5;
};

/// The interior-point method of a step.
struct InteriorPointTolerances {
  /// Of the mean complementarity. No iteration aims lower. Chosen. Smaller: points come near the boundary too soon.
  double smallest_target = 1e-4;
  /// – (fraction). Iterations that go less far along their direction are short. Chosen, as is the next.
  double short_fraction = 1e-2;
  /// So many short iterations, one after the other, end the method.
  int short_iterations = 4;
  /// – (fraction). Of the way to the boundary of the first cone that an iteration may go. Usual. Larger: points stick
  /// to the boundary.
  double to_boundary = 0.99;
  /// Of h. No contact begins with a smaller relative displacement. Chosen. Larger: more iterations.
  double least_displacement = 1e-7;
  /// Of the normal displacement over μ. No contact begins with more slip, so that it begins inside its cone. Chosen.
  double most_slip = 0.5;
  /// Of the longest displacement in free flight. Contacts that stay open by more, and by … Chosen: bodies that are hit
  /// may push others. Larger: more unknowns. Smaller: contacts that come to bear are left out, and Newton's method
  /// has to find them.
  double flight_gap = 0.25;
  /// Of h. … more than this, do not take part.
  double least_gap = 1e-3;
};

/// What contacts are told to be after a step.
struct ContactOutcomeTolerances {
  /// Of h. A bond that has opened by more is broken. Chosen, below the penetration that dynamic stages allow. Larger:
  /// bonds hold across gaps.
  double bond_opening = 2e-4;
};

/// How contacts are made stiffer.
struct PenaltyScalingTolerances {
  /// –. A contact that penetrates too deep gets a spring this many times as stiff, as in Shi's programs. Larger: fewer
  /// rounds, stiffer contacts than needed.
  double factor = 10;
  /// –. The same where that has been done in the step, and did not do. Chosen: a chip of 10⁻⁹ of the mass of the blocks
  /// that squeeze it needs springs 10⁷ times as stiff as it could follow alone. As above.
  double repeated_factor = 100;
  /// Of the tolerance of penetration. A spring that gives by less is not what makes a contact deep. Chosen.
  double least_compression = 0.02;
  /// –. Faces of rigid and affine blocks may lie so many tolerances of penetration deep in each other, as long as their
  /// springs give by one. Chosen: where two blocks have sunk into what carries them, the strip with which one comes to
  /// lie on the other's neighbour is found as deep as both. Held to one tolerance in all, it got a spring that bears
  /// everything: 60 steps of eight slopes of some 600 blocks took 7 400 iterations, 4 800 with 3, and 4 000 with 4.
  /// Larger: blocks deeper in each other. Smaller: stiffer strips, more iterations.
  double faces_in_all = 4;
  /// –. No contact gets stiffer than by this. Beyond it, the rounding of a gap would be a force.
  double largest = 1e6;
};

/// When a body goes on without the acceleration that it had.
struct AccelerationResetTolerances {
  /// – (fraction). A contact force that changes by more of the larger is a blow. Chosen on bodies that land. Larger:
  /// blows are carried over and throw blocks up. Smaller: what slides or rolls loses second order.
  double sudden_change = 0.3;
  /// Of the acceleration. A rigid body swings where it changes by more in a step, and back in the next (by more in the
  /// geometric mean of both). Larger: stiff contacts ring on, and a block on a shaken table slips too soon, by 2 % of
  /// its way at 0.3 (measured). Smaller: swings that steps follow are damped.
  double swing = 0.05;
  /// Of the body's size. Changes of an acceleration that move it by less in a step are no swing. Rounding. Smaller:
  /// what flies freely swings by rounding.
  double visible_swing = 1e-9;
};

/// The law of impact at the end of a step.
struct ImpactTolerances {
  /// Steps. Springs may push out within so many what penetrates, no faster. Chosen. Larger: bodies stay in each other
  /// longer. Smaller: they part faster than they met.
  double steps_to_part = 10;
  /// Of h. Contacts that were open by more at the start of a step have landed in it. That of
  /// ConvergenceTolerances::first_closing. Smaller: contacts at rest are let go by rounding.
  double landing_gap = 2e-7;
  /// – (ωΔ). Springs that swing slower than this in a step are left to themselves: they throw a body back at the same
  /// speed wherever in the step it lands, within 0.07 of that of landing; at three it is 0.13 to 0.48 of it, at ten 0
  /// to 0.7 (measured).
  double followed_oscillation = 2;
  /// Of the speed that a contact's push alone changes in a step. Smaller misses of the law are left. Rounding.
  double negligible_speed = 1e-9;
  /// Of the kinetic energy. What rigid bodies may gain in a step in which some are thrown back, and of the restitution
  /// by how much it is found. Rounding. Larger: restitution with friction makes energy.
  double negligible_energy = 1e-9;
  /// Of the largest push. Impulses that change by less have been found. Rounding. Larger: rebounds depend on the order
  /// of contacts.
  double impulse_accuracy = 1e-9;
  /// Sweeps over all contacts in which impulses are to be found; at standard 108, at draft 34. Larger: time in crowds.
  /// Smaller: less exact rebounds: the kinetic energy of a slope of 317 blocks after 20 steps is 1.3e-4 larger with
  /// 100, 3.8e-4 with 30; of four slopes of some 600 blocks up to 2 % with 108, 5 % with 30. Reaching it is counted in
  /// the report.
  int sweep_limit = 500;
};

/// How stiff springs are that a step can follow.
struct FollowedSpringTolerances {
  /// – (ωΔ). Two bodies swing no faster on the springs between them. 2π: one swing a step, as "near-rigid" contact has
  /// it. Larger: more iterations, four times as many for a crowd at 8π. Smaller: bodies sink visibly when they land.
  double oscillation = 6.283185307179586;
  /// E*/h. Springs on a body with elements are no softer. Chosen: a joint yields no more than the elements beside it,
  /// and a meshed slope of 105 blocks takes 11 iterations a step (18 with 3, 42 with 10, 9 with 0.3). Larger: more
  /// iterations. Smaller: joints yield more than rock.
  double beside_elements = 1;
  /// Of the penetration that contacts may have. Springs that a blow has made stiffer than rock are softened until they
  /// give by this once it is over. Chosen. Larger: softer springs, which the next change of the load makes stiff again,
  /// and blocks that settle take more iterations (docs/notes/crowds.md).
  /// Smaller: springs stay stiffer than what they bear asks for.
  double relaxed_compression = 0.1;
  /// – (fraction). They are softened where they get so much softer or more. Chosen. Larger: springs soften and stiffen
  /// in turns. Smaller: more iterations in debris.
  double worthwhile_softening = 0.1;
  /// Of the penetration that contacts may have. Springs of points with more initial interference stay stiff. Chosen:
  /// each turn of stiffening and softening leaves some. Larger: blocks deeper in each other; with 1, one of 240 random
  /// scenes lies 2e-3 h deep. Smaller: more iterations in debris.
  double relaxed_interference = 0.2;
};

/// How inertia fades in static stages.
struct PseudoTransientTolerances {
  /// –. Inertia fades with the residual to this power (Gropp, Kaushik, Keyes & Smith 2001). Larger: fewer steps to
  /// equilibrium, and more that lead too far.
  double power = 1.5;
  /// – (fraction). A residual that falls by less in a step is that of what slides or falls: inertia comes back. Chosen.
  double steady_residual = 1e-3;
  /// –. By this factor a step. Chosen. Larger: what slides gets all its inertia back sooner.
  double growth = 4;
  /// –. A step with less inertia may lead this many times as far as those with all of it. Chosen. Larger: blocks may
  /// pass an equilibrium. Smaller: inertia fades later.
  double largest_displacement = 2;
  /// – (fraction). Inertia never fades to less: it keeps loose blocks from making the matrix singular. 2⁻²⁰: what a
  /// matrix can tell from the stiffness of contacts. Smaller: factorisations fail.
  double least_inertia = 0x1p-20;
  /// Residual over the largest force. Less is decided by how exactly steps are solved: nothing changes. Ten times
  /// ConvergenceTolerances::static_residual.
  double at_rest = 1e-10;
};

/// How adaptive steps keep to the limits of the project (AdaptiveSteps).
struct StepControlTolerances {
  double target = 0.8;     ///< –, of a limit, so that the next step seldom breaks it. Chosen. Larger: more refusals
  double growth = 1.5;     ///< –, at most, from step to step. Chosen. Larger: more refusals
  double shrinkage = 0.2;  ///< –, at most. Chosen. Larger: more trials until a step is short enough
  double refused_above =
      1.5;  ///< –, of a limit: a step that breaks it by more is taken anew. Chosen: accuracy and time
  double after_many_iterations = 0.7;  ///< –, factor where iterations exceed their limit. Chosen
  double after_refusal = 0.5;          ///< –, factor of a step that is taken anew, at most. Chosen
};

/// When blocks fall asleep, and what wakes them.
struct SleepTolerances {
  /// Mesh sizes a second, below which a body is slow, unless the project says. At standard 1e-6, at draft 1e-5: what
  /// steps leave out of balance keeps bodies going by as much. Chosen. Larger: sleep comes sooner, and bodies that
  /// hardly move yet are stopped. Smaller: bodies at rest stay awake.
  double speed = 1e-9;
  /// Of all forces that a sleeper bears: by more what presses on it must not change. At standard 1e-3, at draft 1e-2.
  /// Chosen: what sinks no more than it did while it was slow. Larger: a sleeper starts later than it should. Smaller:
  /// sleepers wake for nothing, and steps are tried again.
  double load_change = 1e-7;
  /// Steps for which a body has been slow before it falls asleep. Chosen: one that turns back at the top of its flight
  /// is slow for one or two. Larger: sleep comes later. Smaller: bodies fall asleep in flight.
  int slow_steps = 20;
};

/// What effects decide for themselves.
struct EffectTolerances {
  /// Of h. Bodies whose contacts stay open by more share no line search. Five times
  /// ConvergenceTolerances::first_closing, so that whatever a tangent takes for closed is among them. Larger: fewer
  /// separate searches. Smaller: searches that depend on each other are taken as separate.
  double search_gap = 1e-6;
  /// –. A held point's spring over the stiffness of the rock around it, E·h. Chosen. Larger: held points give less, and
  /// round more. Smaller: they give visibly.
  double constraint_stiffness = 100;
  /// Of the size of a block, or of all blocks together. Loads, constraints and monitors may lie outside of their block
  /// by it. Chosen: coordinates in files have six digits. Projects are refused or accepted by it.
  double point_outside_block = 1e-6;
  /// rad. Linear rock that turns by less in a step has the symmetric tangent, whose stress does not act along the mean
  /// rotation. Chosen. Larger: more iterations where blocks spin. Smaller: unsymmetric equations where few turn.
  double negligible_turn = 1e-3;
  /// –. Linear rock keeps its stiffness in Newton's method while no more of its deformation gradient changes: its
  /// forces are always exact. Chosen. Larger: more iterations. Smaller: stiffness is computed more often.
  double stiffness_kept = 1e-5;
  /// – (fraction). An element of neo-Hookean rock keeps this of its volume in an iteration. Chosen. Larger: more
  /// iterations of shorter increments. Smaller: elements nearly turned inside out on the way.
  double kept_volume = 0.1;
  /// Of the strength. A contact that slid at the end of the last step goes on sliding at the start of a stage although
  /// its shear force is below the strength by this: the gap is measured where the point is now. Chosen.
  double slides_on = 1e-3;
  /// Of the shear force. What a trial force exceeds the strength by less is rounding, not slip.
  double least_excess = 1e-12;
  /// Roundings of a coordinate. A slip that is less is none.
  double slip_roundings = 4;
};

/// All that decides how a step is solved.
struct SolverTolerances {
  StepTolerances step;
  ConvergenceTolerances convergence;
  FirstGuessTolerances first_guess;
  InteriorPointTolerances interior_point;
  EliminationTolerances elimination;
  ContactOutcomeTolerances contact_outcome;
  PenaltyScalingTolerances penalty_scaling;
  AccelerationResetTolerances acceleration_reset;
  ImpactTolerances impact;
  FollowedSpringTolerances followed_spring;
  PseudoTransientTolerances pseudo_transient;
  StepControlTolerances step_control;
  SleepTolerances sleep;
  EffectTolerances effects;

  /// What becomes of them at another SolverSettings::tolerance than that of reference, for which the values above are.
  /// Impulses are found as exactly as steps are solved, in sweeps that grow with the sixth root of the exactness. A
  /// larger residual is left to each body alone, not to all together (OpenClose::begin_stage): those of
  /// ConvergenceTolerances get smaller only.
  SolverTolerances at(double tolerance) const;
};

}  // namespace talus
