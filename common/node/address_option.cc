#include "common/node/address_option.h"

#include <CLI/CLI.hpp>
#include <stdexcept>

namespace cell {

void AddressOption::AddTo(CLI::App& app) {
  app.add_option("--url", url, "LCM address of the cell; control port: +1")
      ->capture_default_str();
  app.add_flag("--allow-network", may_use_network,
               "allow a ttl above 0 in --url, which reaches other hosts");
}

LcmAddress AddressOption::Get() const {
  const LcmAddress address = LcmAddress::Parse(url);
  if (address.ttl > 0 && !may_use_network) {
    throw std::invalid_argument(
        "--url " + url + ": with ttl=" + std::to_string(address.ttl) +
        " everyone on the network hears the cell and can speak in its name; "
        "if that is intended, add --allow-network");
  }
  return address;
}

}  // namespace cell
