#pragma once

#include "common/imaging/rgbd_frame.h"

namespace cell::cli {

/// The depth of a frame in grey: the nearer, the brighter, from the furthest to
/// the nearest in the picture, with a scale in m at its foot; black where there
/// is no measurement.
RgbImage GreyOfDepth(const RgbdFrame& frame);

}  // namespace cell::cli
