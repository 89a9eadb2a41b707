#pragma once

#include <string>

namespace cell {

// A rover among stations: a drive uses up its charge half of the time, some
// stations have a spare battery, and the short way has none.
inline constexpr char kRover[] = R"((define (domain rover)
  (:types station)
  (:predicates (at ?s - station) (way ?a ?b - station) (spare ?s - station)
               (charged) (carries))
  (:action drive :parameters (?a ?b - station)
    :precondition (and (at ?a) (way ?a ?b) (charged))
    :effect (and (at ?b) (not (at ?a)) (probabilistic 1/2 (not (charged)))))
  (:action take :parameters (?s - station)
    :precondition (and (at ?s) (spare ?s) (not (carries)))
    :effect (and (carries) (not (spare ?s))))
  (:action change :precondition (carries)
    :effect (and (charged) (not (carries)))))
)";

// A ladder of stations: spares along one rail, the goal at the other's end.
inline std::string LadderProblem(int length) {
  std::string objects, init = "(at a0) (charged)";
  for (int i = 0; i < length; ++i) {
    const std::string n = std::to_string(i);
    const std::string next = std::to_string(i + 1);
    objects += " a" + n + " b" + n;
    init += " (spare b" + n + ") (way a" + n + " b" + n + ") (way b" + n +
            " a" + n + ")";
    if (i + 1 == length) break;
    init += " (way a" + n + " a" + next + ") (way b" + n + " b" + next +
            ") (way b" + next + " b" + n + ")";
  }
  return "(define (problem ladder) (:domain rover) (:objects" + objects +
         " - station) (:init " + init + ") (:goal (at a" +
         std::to_string(length - 1) + ")))";
}

}  // namespace cell
