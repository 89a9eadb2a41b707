// supervisor: decides whether arms may move, and reports faults.
#include "common/node/run_service.h"
#include "services/supervisor/supervisor.h"

int main(int argc, char** argv) {
  return cell::RunService("supervisor", argc, argv,
                          cell::supervisor::MakeSupervisor);
}
