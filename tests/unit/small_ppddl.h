#pragma once

#include <string>

namespace cell {

// A courier with one parcel; the bridge may break under it, the road is long.
inline constexpr char kCourier[] = R"((define (domain courier)
  (:requirements :typing :probabilistic-effects :conditional-effects)
  (:types place parcel - object town - place)
  (:constants depot - town)
  (:predicates (at ?p - place) (road ?a ?b - place) (bridge ?a ?b - place)
               (broken) (in ?x - parcel ?p - place) (loaded ?x - parcel))
  (:action drive :parameters (?a ?b - place)
    :precondition (and (at ?a) (road ?a ?b))
    :effect (and (at ?b) (not (at ?a)) (increase (total-cost) 1)))
  (:action cross :parameters (?a ?b - place)
    :precondition (and (at ?a) (bridge ?a ?b) (not (broken)))
    :effect (probabilistic 0.75 (and (at ?b) (not (at ?a)))
                           1/4 (broken)))
  (:action load :parameters (?x - parcel ?p - place)
    :precondition (and (at ?p) (in ?x ?p))
    :effect (probabilistic 1/2 (and (loaded ?x) (not (in ?x ?p)))))
  (:action unload :parameters (?x - parcel ?p - place)
    :precondition (and (at ?p) (loaded ?x))
    :effect (and (in ?x ?p) (not (loaded ?x)))))
)";

// Over the bridge only: 3/4. With a road from m to t: certain.
inline constexpr char kDelivery[] = R"((define (problem delivery)
  (:domain courier)
  (:objects m t - town x - parcel)
  (:init (at depot) (in x depot) (road depot m) (road m depot)
         (bridge m t) (= (total-cost) 0))
  (:goal (in x t))
  (:metric minimize (total-cost))))";

/// `text` with a part of it replaced.
inline std::string With(std::string text, const std::string& part,
                        const std::string& other) {
  const size_t place = text.find(part);
  return place == std::string::npos ? "'" + part + "' is not there"
                                    : text.replace(place, part.size(), other);
}

}  // namespace cell
