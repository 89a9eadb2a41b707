#pragma once

#include <string>

#include "services/vtb/hand_stage.h"

/// What a hand can do, each in a file of its own under hand_actions/. An action
/// leaves the hand where the one that usually follows can begin.
namespace cell::vtb::hand_action {

/// Over everything to one of the part's grasps, with open fingers; to the
/// handle of an articulated part straight from before it.
HandAction Reach(const std::string& part);
/// Closes the fingers about the part that was reached for. If somebody else
/// holds it by then, the hand gives up all that it was to do and goes to rest.
HandAction Grasp(const std::string& part);
/// Pulls a held part straight out of its site.
HandAction Extract(const std::string& site);
/// Carries a held part over everything to where its straight way in begins.
HandAction Carry(const std::string& part, const Target& target);
/// Lowers a held part along the way in and presses until it is seated; searches
/// by small circles, and tries again from above. One that does not seat in
/// spite of all tries is a failure. An attempt is given up at once: the part
/// goes to its place on the table, and the hand to its rest.
HandAction Insert(const std::string& part, const Target& target);
/// Turns a part on a thread between the fingertips until it is home; nothing
/// elsewhere.
HandAction Turn(const std::string& part, const Target& target);
/// Lets go of a held part, which no force moves then.
HandAction Release(const std::string& part);
/// Straight back from what was let go.
HandAction Retreat();
/// Over everything to the hand's place, with or without a part.
HandAction Rest();
/// Turns a held part on its hinge to the upper limit, or to the lower one. One
/// that does not come there is a failure.
/// @throws std::invalid_argument as it begins, unless the part has a hinge.
HandAction Open(const std::string& part);
HandAction Close(const std::string& part);
/// The same of a held part on a slide.
HandAction Pull(const std::string& part);
HandAction Push(const std::string& part);
/// Stays as it is for `duration` [s].
HandAction Pause(double duration);

}  // namespace cell::vtb::hand_action
