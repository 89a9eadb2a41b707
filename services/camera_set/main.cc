// camera_set: the pictures of one camera set.
#include "common/node/run_service.h"
#include "services/camera_set/camera_set.h"

int main(int argc, char** argv) {
  return cell::RunInstance("camera_set", argc, argv,
                           cell::camera_set::MakeCameraSet);
}
