// recognizer: names the manipulations in the stream of key frames.
#include "common/node/run_service.h"
#include "services/recognizer/recognizer.h"

int main(int argc, char** argv) {
  return cell::RunService("recognizer", argc, argv,
                          cell::recognizer::MakeRecognizer);
}
