// SPDX-License-Identifier: BSL-1.0
#pragma once

/// \file
/// The rows of `peers cases`: which of the hard cases are played, what is measured, and what it must not exceed. The
/// list is in table.cpp, the scenes in bounces.cpp, heaps.cpp, sleep.cpp and springs.cpp.

#include "tests/peers/cases/engine.hpp"

#include <string>
#include <vector>

namespace peers {

/// One row. What is measured is an error or a count, so that less is better and zero is best.
struct Played {
    std::string id;   ///< of tests/hard_cases.txt
    std::string what; ///< what is measured
    std::string unit;
    double bound; ///< of the catalogue, for double
    double bound_float;
    double (*measure)(const Contestant&);
    bool slop = false; ///< an engine's own slop is added to the bound: it lets bodies lie that deep on purpose
};
/// A row of the catalogue that is not played, and why.
struct LeftOut {
    std::string rows, why;
};

std::vector<Played> rows();
const std::vector<LeftOut>& left_out();

/// \name The measures, by the row's name
/// @{
double c1_impulse(const Contestant&);
double c2_side_by_side(const Contestant&);
double c3_parting(const Contestant&);
double c4_across(const Contestant&);
double c5_mass_ratio(const Contestant&);
double c6_fixed_in_fixed(const Contestant&);
double c8_twenty_bounces(const Contestant&);
double c9_zeno(const Contestant&);
double c11_one_centre(const Contestant&);
double c14_swapped(const Contestant&);
double c15_ten_kilometres(const Contestant&);
double c15_ten_thousand_kilometres(const Contestant&);
double c17_plane(const Contestant&);
double c18_discrete(const Contestant&);
double c18_continuous(const Contestant&);
double c19_swarm(const Contestant&);
double c20_bullets(const Contestant&);
double c21_speed(const Contestant&);
double c21_depth(const Contestant&);
double c24_centre_of_mass(const Contestant&);
double c25_ramp(const Contestant&);
double c26_heap(const Contestant&);
double c27_elastic(const Contestant&);
double r4_60(const Contestant&);
double r4_100(const Contestant&);
double r4_300(const Contestant&);
double r4_400(const Contestant&);
double r4_speed(const Contestant&);
double r5_aside(const Contestant&);
double r5_energy(const Contestant&);
double r7_rise(const Contestant&);
double r8_soft_floor(const Contestant&);
double r9_apex(const Contestant&);
double r10_exact(const Contestant&);
double r11_wake(const Contestant&);
double r12_pile(const Contestant&);
double r13_creep(const Contestant&);
double r14_order(const Contestant&);
double r14_jitter(const Contestant&);
double r15_long(const Contestant&);
double r16_way(const Contestant&);
double r16_place(const Contestant&);
double r17_out(const Contestant&);
double r17_speed(const Contestant&);
double v3_energy(const Contestant&);
double v7_far(const Contestant&);
double i8_free_fall(const Contestant&);
double i13_kepler(const Contestant&);
double i23_damping(const Contestant&);
double s1_recurrence(const Contestant&);
double s2_damped(const Contestant&);
double s2_swings_over(const Contestant&);
double s3_stiff(const Contestant&);
double s4_no_length(const Contestant&);
double s5_centre(const Contestant&);
double s5_frequency(const Contestant&);
double s6_chain(const Contestant&);
double s8_ball_and_chain(const Contestant&);
double s9_resonance(const Contestant&);
double g1_random(const Contestant&);
double g1_told(const Contestant&);
double g3_touching(const Contestant&);
double g4_one_place(const Contestant&);
double g5_large(const Contestant&);
double g14_far(const Contestant&);
/// @}

} // namespace peers
