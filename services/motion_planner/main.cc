// motion_planner: finds ways for the arms.
#include "common/node/run_service.h"
#include "services/motion_planner/motion_planner.h"

int main(int argc, char** argv) {
  return cell::RunService("motion_planner", argc, argv,
                          cell::motion_planner::MakeMotionPlanner);
}
