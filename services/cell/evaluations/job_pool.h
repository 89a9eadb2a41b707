#pragma once

#include <functional>
#include <string>
#include <vector>

namespace cell::cli {

/// Runs `job(i)` for every i of `indices` in processes of their own, at most
/// `num_processes` at a time; `done(i, result)` is called for each result, in
/// the order of completion. A job that dies or throws gives an empty result.
/// `may_go_on` is called at least twice a second; once it returns false,
/// running jobs are ended without a result. Device adapter.
void RunJobs(
    const std::vector<size_t>& indices, int num_processes,
    const std::function<std::string(size_t)>& job,
    const std::function<void(size_t, const std::string&)>& done,
    const std::function<bool()>& may_go_on = [] { return true; });

}  // namespace cell::cli
