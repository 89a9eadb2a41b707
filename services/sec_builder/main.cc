// sec_builder: publishes a key frame whenever the scene's topology changes.
#include "common/node/run_service.h"
#include "services/sec_builder/sec_builder.h"

int main(int argc, char** argv) {
  return cell::RunService("sec_builder", argc, argv,
                          cell::sec_builder::MakeSecBuilder);
}
