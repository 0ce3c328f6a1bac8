// SPDX-License-Identifier: BSL-1.0
// Which of the hard cases are played beside other engines, and which are not, and why. This is the place that decides.
//
// Played is every row that can be said in balls, planes, fixed boxes, platforms, springs and boxes of a broadphase,
// whoever does well in it. Bounds are those of the catalogue; where it leaves one open, it is what our own test asks.

#include "tests/peers/cases/rows.hpp"

namespace peers {

namespace {

// row, what is measured, unit, bound, bound for float, measure[, the engine's slop is added to the bound]
const std::vector<Played> flights{
    {"I8", "free fall of 1 s at 60 Hz, off the parabola", "m", 0.081751, 0.0818, i8_free_fall},
    {"I13", "Kepler's orbit, e = 0.6, 100 periods of 1000 steps: largest error of the energy", "of it", 2.5e-2, 2.5e-2,
     i13_kepler},
    {"I23", "damping of 1 s at 30, 60 and 120 Hz: how far the velocities differ", "of it", 1e-9, 1e-5, i23_damping},
};
const std::vector<Played> bounces{
    {"C1", "two of 1 and 3 kg meet, e = 0 to 1: error of the velocities after it", "m/s", 1e-12, 1e-6, c1_impulse},
    {"C2", "side by side at 5 m/s, 1 cm in each other: change of velocity", "m/s", 1e-12, 1e-6, c2_side_by_side},
    {"C3", "1 cm in each other and separating at 2 m/s: change of velocity", "m/s", 1e-12, 1e-6, c3_parting},
    {"C4", "what goes across a hit without friction: its change", "m/s", 0, 0, c4_across},
    {"C5", "elastic hit, 1 to 1e3, 1e6, 1e9, heavy and light come: error of the velocities", "m/s", 1e-12, 1e-6,
     c5_mass_ratio},
    {"C6", "two fixed boxes in each other, and a ball on them: faults", "", 0, 0, c6_fixed_in_fixed},
    {"C8", "20 bounces from 10 m, e = 1: worst height against the first", "of it", 0.01, 0.01, c8_twenty_bounces},
    {"C9", "e = 1/2 from 1 m: speed from 1.5 s on", "m/s", 0.05, 0.05, c9_zeno},
    {"C11", "two with one centre, after 5 s: overlap that is left", "m", 5e-3, 5e-3, c11_one_centre, true},
    {"C14", "the two of a hit added in the other order: difference of their places", "m", 0, 0, c14_swapped},
    {"C15", "a ball laid on a box 10 km to the side and up: its height is off by", "m", 1.9e-12, 9.8e-4,
     c15_ten_kilometres},
    {"C15", "hit of two 10,000 km from the origin: error of the velocities", "m/s", 1e-9, 1e-9,
     c15_ten_thousand_kilometres},
    {"C17", "a plane at 2 m and one at 1002 m: difference of where a ball lies", "m", 1e-12, 1.3e-4, c17_plane},
    {"C18", "balls of 0.1 m at 17.9 m/s against a wall of 0.1 m, discrete detection: through, of 100", "", 0, 0,
     c18_discrete},
    {"C18", "the same at 200 m/s with continuous detection: through, of 100", "", 0, 0, c18_continuous},
    {"C19", "5000 at 250 m/s in a box with walls of 1 m (flat: 1000), 500 steps: escaped", "", 0, 0, c19_swarm},
    {"C20", "two of 5 cm head on at 100 m/s each: through each other, of 100", "", 0, 0, c20_bullets},
    {"C21", "pyramid of ten, a quarter in each other: largest speed", "m/s", 4, 4, c21_speed},
    {"C21", "the same after 2 s: overlap that is left", "m", 5e-3, 5e-3, c21_depth, true},
    {"C24", "1 and 9 kg, 10 cm in each other: way of their centre of mass", "m", 1e-12, 1e-6, c24_centre_of_mass},
    {"C25", "slope of 0.25 rad, friction 0 to 0.75: error of the acceleration", "m/s2", 1e-2, 1e-2, c25_ramp},
    {"C26", "216 in a box (flat: 225), without friction, after 10 s: deepest overlap", "m", 2.5e-3, 2.5e-3, c26_heap,
     true},
    {"C27", "49 elastic balls, 100 s: largest error of the energy", "of it", 0.01, 0.01, c27_elastic},
};
const std::vector<Played> heaps_and_rest{
    {"R4", "60 kg on 1 kg, 10 s: the light one moves", "m", 0.01, 0.01, r4_60},
    {"R4", "100 kg on 1 kg", "m", 0.01, 0.01, r4_100},
    {"R4", "300 kg on 1 kg", "m", 0.01, 0.01, r4_300},
    {"R4", "400 kg on 1 kg", "m", 0.01, 0.01, r4_400},
    {"R4", "all four from 5 s on: largest speed", "m/s", 0.05, 0.05, r4_speed},
    {"R5", "ten spheres fall into a column, 10 s: to the side", "m", 1e-6, 1e-5, r5_aside},
    {"R5", "the same: mean kinetic energy", "J", 1e-9, 1e-5, r5_energy},
    {"R7", "100 kg taken off two of 1 kg: they rise above where they lie without it by", "m", 1e-3, 1e-3, r7_rise},
    {"R8", "soft floors of 1e3 to 1e6 N/m after 50 s: error of the depth mg/k", "m", 1e-10, 1e-3, r8_soft_floor},
    {"R9", "flights of 4 s under 0.01 to 9.81 m/s2, dropped and thrown: asleep in the air, of 8", "", 0, 0, r9_apex},
    {"R10", "sleepers that are not exactly still, and others that notice", "", 0, 0, r10_exact},
    {"R11", "seven ways to lose one's rest: unnoticed", "", 0, 0, r11_wake},
    {"R12", "a pile of 1000 with friction: all asleep after", "s", 10, 10, r12_pile},
    {"R13", "creeping at 0.9 of the threshold for 60 s: neither on nor still, times", "", 0, 0, r13_creep},
    {"R14", "15 in five columns, added in other orders: largest difference of a place", "m", 1e-9, 1e-5, r14_order},
    {"R14", "ten times the gravity, e = 1/2, after 5 s: mean speed", "m/s", 0.01, 0.01, r14_jitter},
    {"R15", "two at rest for 100,000 steps: moved", "m", 1e-3, 1e-3, r15_long},
    {"R16", "all lengths times 0.001 and 1000, four balls fall: difference of their ways", "of them", 1e-9, 1e-5,
     r16_way},
    {"R16", "the same: difference of where they lie from 3 s on", "of it", 1e-9, 1e-5, r16_place},
    {"R17", "1, 2 and 5 balls, 1 to 1, 3 and 100, in a press of 0.3 and 3 m/s: one comes through it by", "m", 0, 0,
     r17_out},
    {"R17", "the same: the fastest ball, over the press", "", 1.05, 1.05, r17_speed},
};
const std::vector<Played> energies{
    {"V3", "125 in a box (flat: 100), e = 1 and 1/2, 10 s: energy gained", "of it", 1e-12, 1e-5, v3_energy},
    {"V7", "0.05 m/s at 240 Hz, 512 and 4096 m from the origin: error of a way of 1 m", "of it", 0.01, 0.01, v7_far},
};
const std::vector<Played> springs{
    {"S1", "spring of 2 Hz at 60 Hz, 120 steps: off the recurrence of an implicit step", "of x0", 5e-6, 5e-6,
     s1_recurrence},
    {"S2", "damped spring, zeta 0.1, 1 and 10, at 240 Hz: off the closed form", "of x0", 0.1, 0.1, s2_damped},
    {"S2", "zeta 1 and 10: swings over by", "of x0", 1e-14, 1e-6, s2_swings_over},
    {"S3", "1e6 N/m on 1 kg at 60 Hz, undamped: largest swing", "of x0", 1.01, 1.01, s3_stiff},
    {"S4", "ends in one place, rest lengths 0 and 1 m: faults", "", 0, 0, s4_no_length},
    {"S5", "1 and 1000 kg on a spring, 20 s: way of their centre", "m", 2e-12, 2e-5, s5_centre},
    {"S5", "the same: error of the frequency", "of it", 4.5e-5, 1e-4, s5_frequency},
    {"S6", "chain of 20 links, hung for 2 minutes: error of its length", "m", 1e-6, 1e-4, s6_chain},
    {"S8", "40 links, the end 200 times as heavy: error of the stretch", "of it", 0.01, 0.01, s8_ball_and_chain},
    {"S9", "driven at resonance: error of the swing", "of it", 0.01, 0.01, s9_resonance},
};
const std::vector<Played> broadphases{
    {"G1", "1000 scenes of up to 400 boxes: pairs that are missing, or told twice", "", 0, 0, g1_random},
    {"G1", "the same: pairs told that do not touch", "%", 0, 0, g1_told},
    {"G3", "a board of 400 squares: neighbours that are missing", "", 0, 0, g3_touching},
    {"G4", "1000 boxes in one place: missing of 499,500", "", 0, 0, g4_one_place},
    {"G5", "one around all, one through all, one far away: missing", "", 0, 0, g5_large},
    {"G14", "boxes at the origin and 1e9 m away: missing", "", 0, 0, g14_far},
};

} // namespace

std::vector<Played> rows() {
    std::vector<Played> all;
    for (const auto& group : {flights, bounces, heaps_and_rest, energies, springs, broadphases})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

const std::vector<LeftOut>& left_out() {
    static const std::vector<LeftOut> all{
        {"I1 I2 I3 I4 I5 I6 I7 I9 I10 I11 I12 I14 I15 I16 I17 I18",
         "they compare integrators; an engine has one, and no choice"},
        {"I19", "the other three promise nothing of the kind; Bullet writes a world to a file, Box2D dumps one"},
        {"I20", "it compares compilers"},
        {"I21", "what must be refused; the other three leave that to the caller"},
        {"I22 I24", "a clock and an accumulator are around an engine, not in it; Bullet has an accumulator"},
        {"C12 C13", "they ask the narrowphase for one number; what counts of it in a world is in C11, C14 and C15"},
        {"C22 C23", "springs between bodies that touch, as a response, are ours alone"},
        {"C28", "convex shapes: we have none, the other three do"},
        {"R1 R3", "they need the state of a solver between its iterations"},
        {"R6", "fifteen boxes: ours do not tip, so that standing would be no merit"},
        {"V1 V5 V6 V9 V10", "they hold promises that our documentation makes, and others do not"},
        {"V2 V4", "R11 and R7 are what can be said of them for all"},
        {"V8", "it is about one of our responses"},
        {"S10", "elastic ropes are ours alone; others have rigid ones"},
        {"K1 K2 K3 K4 K5 K6 K7 K8 K9 K10 K12", "cloth: of the other three Bullet has it; ./workbook peers soft_bodies"},
        {"W1 W2 W3 W4 W5 W6 W7 W8 W9 W10 W11 W13 W15 W16 W17", "water: none of the other three has it"},
        {"B1 B2 B4 B5 B7 B8 B9 B10", "buoyancy: none of the other three has it"},
        {"G2 G6 G7", "they are inside of our grids and trees; G1 asks on both sides of the origin"},
        {"G9", "what must be refused; the other three leave that to the caller"},
        {"G10 G11 G12", "how pairs are kept from step to step is within each engine's own world"},
        {"P1 P3 P4 P5 P6 P7 P9 P10", "paths and states: none of the other three has them"},
        {"N1 N2 N3 N4 N5", "what a policy that is left out costs: others have no policies"},
        {"T1 T2 T3 T4 T5 T6 T7 T8 T9 T10 T11 T12 T13 T14 T15 T16 T17 T18 T19 T20",
         "what the notes say; they hold by other rows"},
    };
    return all;
}

} // namespace peers
