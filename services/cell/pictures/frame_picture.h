#pragma once

#include "common/imaging/rgbd_frame.h"

namespace cell::cli {

/// What a frame has measured, as grey: the nearer, the brighter, from the
/// furthest to the nearest in the picture, which its foot says in m; black
/// where nothing was measured.
RgbImage GreyOfDepth(const RgbdFrame& frame);

}  // namespace cell::cli
