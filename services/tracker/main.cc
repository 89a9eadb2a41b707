// tracker: publishes the poses of parts and hands.
#include "common/node/run_service.h"
#include "services/tracker/tracker.h"

int main(int argc, char** argv) {
  return cell::RunService("tracker", argc, argv, cell::tracker::MakeTracker);
}
