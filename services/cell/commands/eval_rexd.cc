#include <fmt/format.h>
#include <CLI/CLI.hpp>
