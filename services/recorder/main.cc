// recorder: writes every channel of a run into its folder.
#include "common/node/run_service.h"
#include "services/recorder/recorder.h"

int main(int argc, char** argv) {
  return cell::RunService("recorder", argc, argv, cell::recorder::MakeRecorder);
}
