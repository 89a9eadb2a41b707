#include "common/node/run_service.h"
#include "services/robot_arm/robot_arm.h"

int main(int argc, char** argv) {
  return cell::RunInstance("robot_arm", argc, argv,
                           cell::robot_arm::MakeRobotArm);
}
