#include "tools/mien/terminal/outer_work.h"

#include <utility>

namespace mien::command {
namespace {

const OuterWork* work_around = nullptr;

}  // namespace

OuterWork::OuterWork(std::string where, Progress whole, double from, double to)
    : where_(std::move(where)), whole_(std::move(whole)), from_(from), to_(to) {
  work_around = this;
}

OuterWork::~OuterWork() {
  work_around = nullptr;
}

const OuterWork* OuterWork::present() {
  return work_around;
}

}  // namespace mien::command
