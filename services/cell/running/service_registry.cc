#include "services/cell/running/service_registry.h"

#include <string>

#include "common/layout/cell_layout.h"
#include "common/node/run_service.h"
#include "common/task/task.h"
#include "services/camera_set/camera_set.h"
#include "services/library/library.h"
#include "services/library/open_store.h"
#include "services/motion_planner/motion_planner.h"
#include "services/planner/planner.h"
#include "services/predicate_estimator/predicate_estimator.h"
#include "services/recognizer/recognizer.h"
#include "services/recorder/recorder.h"
#include "services/robot_arm/robot_arm.h"
#include "services/sec_builder/sec_builder.h"
#include "services/supervisor/supervisor.h"
#include "services/tracker/tracker.h"
#include "services/vtb/vtb.h"

namespace cell::cli {

using namespace camera_set;
using namespace library;
using namespace motion_planner;
using namespace planner;
using namespace predicate_estimator;
using namespace recognizer;
using namespace recorder;
using namespace robot_arm;
using namespace sec_builder;
using namespace supervisor;
using namespace tracker;
using namespace vtb;

std::map<std::string, ServiceFactory> AllServices(
    const Deployment& deployment, const std::string& demonstration,
    uint64_t seed) {
  const auto of = [&deployment](const ServiceMaker& maker) -> ServiceFactory {
    return [maker, deployment](Bus& bus) {
      return maker(bus, deployment);
    };
  };
  std::map<std::string, ServiceFactory> factories = {
      {"vtb",
       [=](Bus& bus) {
         return MakeVtb(bus, deployment, demonstration, seed);
       }},
      {"tracker", of(MakeTracker)},
      {"sec_builder", of(MakeSecBuilder)},
      {"recognizer", of(MakeRecognizer)},
      {"predicate_estimator", of(MakePredicateEstimator)},
      {"planner", of(MakePlanner)},
      {"motion_planner", of(MakeMotionPlanner)},
      {"supervisor", of(MakeSupervisor)},
      {"recorder", of(MakeRecorder)},
  };
  // The incarnations of the library share one store, as they share a disk.
  factories["library"] =
      [deployment, store = std::shared_ptr<ActionStore>()](Bus& bus) mutable {
        if (!store) store = OpenStore(deployment, {});
        return MakeLibrary(bus, deployment, store);
      };
  const CellLayout layout = LoadTask(deployment).layout;
  for (const ArmLayout& arm : layout.arms) {
    factories["robot_arm@" + arm.name] = [deployment,
                                          name = arm.name](Bus& bus) {
      return MakeRobotArm(bus, deployment, name);
    };
  }
  const size_t num_cameras =
      layout.cameras ? layout.cameras->azimuths.size() : 0;
  for (size_t i = 1; i <= num_cameras; ++i) {
    factories["camera_set@" + std::to_string(i)] =
        [deployment, set = std::to_string(i)](Bus& bus) {
          return MakeCameraSet(bus, deployment, set);
        };
  }
  return factories;
}

}  // namespace cell::cli
