// predicate_estimator: reports which predicates of the task are true now.
#include "common/node/run_service.h"
#include "services/predicate_estimator/predicate_estimator.h"

int main(int argc, char** argv) {
  return cell::RunService("predicate_estimator", argc, argv,
                          cell::predicate_estimator::MakePredicateEstimator);
}
