#include "common/node/run_service.h"
#include "services/planner/planner.h"

int main(int argc, char** argv) {
  return cell::RunService("planner", argc, argv, cell::planner::MakePlanner);
}
