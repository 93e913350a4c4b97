// SPDX-License-Identifier: Apache-2.0
//
// What evil objects do, by the last word of their id; evil_scene.cpp does it.
#pragma once

#include <vector>

#include "evil.hpp"

namespace {

const std::vector<evil::Fault> kObjectFaults = {
    {"good", "Does nothing wrong."},
    {"force_nan", "Pushes with a force that is no number."},
    {"force_infinite", "Pushes with an infinite force."},
    {"force_huge", "Pushes with 1e9 N."},
    {"torque_nan", "Turns with a torque that is no number."},
    {"signal_nan", "Writes a signal that is no number."},
    {"state_nan", "Keeps a number that is none."},
    {"state_infinite", "Keeps an infinite number."},
    {"neighbour_pose", "Moves its neighbour."},
    {"neighbour_twist", "Gives its neighbour a speed."},
    {"neighbour_late", "Moves its neighbour in finish()."},
    {"forces_refuses", "Answers forces() with an error."},
    {"finish_refuses", "Answers finish() with an error."},
    {"sleeps", "Sleeps 2 ms in each step."},
    {"sleeps_long", "Sleeps 300 ms in each step."},
    {"burns", "Needs 2 ms of a processor in each step."},
    {"create_null", "Creates nothing."},
    {"create_bare", "Creates an instance without functions."},
    {"no_table", "Has no table of an object."},
    {"table_gaps", "Has a table of an object without finish."},
    {"no_trait", "Does not offer the trait that it lists."},
    {"configure_refuses", "Refuses its parameters and does not say why."},
    {"activate_refuses", "Refuses to start and does not say why."},
    {"bodies_many", "Declares a thousand bodies."},
    {"shapes_many", "Declares a million shapes."},
    {"state_much", "Asks for 2^30 private numbers in pieces."},
    {"signals_many", "Declares a thousand signals."},
    {"particles_many", "Declares a million particles."},
    {"pose_nan", "Starts at a pose that is no number."},
    {"mass_zero", "Has a dynamic body without mass."},
    {"mass_nan", "Has a mass that is no number."},
    {"inertia_impossible", "Has moments of inertia that no body has."},
    {"radius_negative", "Has a sphere of a negative radius."},
    {"radius_infinite", "Has an infinite sphere."},
    {"centre_far", "Has a sphere 1e300 m away from its body."},
    {"shape_of_nobody", "Fixes a shape to a body that it has not declared."},
    {"flags_unknown", "Has a shape with flags that nobody knows."},
    {"motion_unknown", "Has a body that moves in no known way."},
    {"hinge_of_itself", "Hinges a body to itself."},
    {"hinge_missing", "Has a hinged body without a hinge."},
    {"convex_huge", "Has a polyhedron that claims four billion vertices."},
    {"convex_wild", "Has a polyhedron whose faces name vertices that it has not."},
    {"metric_declared", "Declares what belongs to lessons."},
    {"declares_unknown", "Declares what nobody knows."},
    {"signal_unnamed", "Declares a signal without a name."},
    {"signal_twice", "Declares one signal twice."},
    {"doc_endless", "Describes its signal in 64 MB."},
    {"self_alone", "Wants to move by itself and has no solver."},
    {"talks_endlessly", "Reports a million times."},
};

}  // namespace
