// vtb: the virtual testbed, owner of time in lockstep (section IV).
#include "common/node/run_clock.h"
#include "services/vtb/vtb.h"

int main(int argc, char** argv) {
  return cell::RunClock("vtb", argc, argv, cell::vtb::MakeVtb);
}
