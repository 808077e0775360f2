#include "render/image/write_pieces.h"
#include "lib/base/monotonic_seconds.h"
#include "render/image/file/atomic_file.h"
#include "render/image/file/output_path.h"
#include "render/image/file_type.h"
#include "render/image/ordered_pipeline.h"

#include <fcntl.h>
#include <unistd.h>

#include <vector>

namespace mien {
namespace fs = std::filesystem;

namespace {

/// Pieces beside those being made: one waits to be put, one is being put.
constexpr int kSpareSlots = 2;

class Writing {
 public:
  Writing(const PiecesToWrite& what, const WriteOptions& how, PictureEncoder& encoder)
      : what_(what),
        how_(how),
        encoder_(encoder),
        watch_(how.progress),
        prepared_(std::size_t(encoder.slots())),
        took_(prepared_.size()) {}

  Expected<PieceTimes> run() {
    const int pieces = encoder_.pieces();
    if (watch_.done(0)) return Error{"", "cancelled"};
    const bool all = ordered_pipeline(
        pieces, encoder_.slots(), how_.threads, [&](int i, int slot) { return make(i, slot); },
        [&](int i, int slot) { return put(i, slot, pieces); });
    if (!put_) return put_.error();
    if (!all) return Error{"", "cancelled"};
    if (auto finished = encoder_.finish(); !finished) return finished.error();
    if (watch_.done(1)) return Error{"", "cancelled"};
    return times_;
  }

 private:
  bool make(int i, int slot) {
    const PixelBuffer pixels = what_.pixels(encoder_.piece(i), slot, watch_);
    if (!pixels.data || watch_.stopped()) return false;
    const double began = monotonic_seconds();
    encoder_.prepare(i, slot, pixels, prepared_[std::size_t(slot)], [&] { return watch_.ask(); });
    took_[std::size_t(slot)] = monotonic_seconds() - began;
    return !watch_.ask();
  }

  bool put(int i, int slot, int pieces) {
    const double began = monotonic_seconds();
    put_ = encoder_.put(i, prepared_[std::size_t(slot)]);
    times_.put += monotonic_seconds() - began;
    times_.encode += took_[std::size_t(slot)];
    // The last step is the file's, when all is on the disk.
    if (!put_ || watch_.done(double(i + 1) / (pieces + 1))) watch_.stop();
    return !watch_.stopped();
  }

  const PiecesToWrite& what_;
  const WriteOptions& how_;
  PictureEncoder& encoder_;
  StopWatch watch_;
  std::vector<PreparedPiece> prepared_;  // by slot
  std::vector<double> took_;
  PieceTimes times_;
  Expected<Done> put_ = Done{};
};

Expected<PieceTimes> write_into(const PiecesToWrite& what, FileType type, const WriteOptions& how,
                                const MakeEncoder& make, FileOutput& out) {
  const PieceBudget budget{thread_count(how.threads) + kSpareSlots, what.memory};
  const auto encoder = make({what.frame, type, how, budget, out});
  if (!encoder) return encoder.error();
  return Writing(what, how, **encoder).run();
}

Expected<PieceTimes> write_device(const PiecesToWrite& what, FileType type, const WriteOptions& how,
                                  const MakeEncoder& make, const fs::path& path) {
  const auto descriptor = open_stream(path);
  if (!descriptor) return descriptor.error();
  const ClosedInTheEnd closed(*descriptor);
  FileOutput out(*descriptor, ::lseek(*descriptor, 0, SEEK_CUR) < 0);
  return write_into(what, type, how, make, out);
}

Expected<PieceTimes> write_whole(const PiecesToWrite& what, FileType type, const WriteOptions& how,
                                 const MakeEncoder& make, const fs::path& path) {
  auto file = AtomicFile::begin(path);
  if (!file) return Error{"", file.error().what};
  FileOutput out(file->descriptor(), false);
  auto took = write_into(what, type, how, make, out);
  if (!took) return took;
  if (auto done = file->commit(); !done) return Error{"", done.error().what};
  return took;
}

Expected<PieceTimes> write_to(const PiecesToWrite& what, const fs::path& path,
                              const WriteOptions& how, const MakeEncoder& make) {
  const auto type = chosen_type(path, how);
  if (!type) return type.error();
  if (auto fits = check_fits(what.frame, *type); !fits) return fits.error();
  if (path == "-") {
    // In order, whatever standard output is: behind what a file already holds, too.
    FileOutput out(STDOUT_FILENO, true);
    return write_into(what, *type, how, make, out);
  }
  const auto target = find_output_path(path);
  if (!target) return target.error();
  return target->stream ? write_device(what, *type, how, make, target->path)
                        : write_whole(what, *type, how, make, target->path);
}

}  // namespace

bool StopWatch::ask() {
  if (progress_ && !stopped_ && asking_.try_lock()) {
    const std::lock_guard lock(asking_, std::adopt_lock);
    if (!progress_(share_)) stopped_ = true;
  }
  return stopped_;
}

bool StopWatch::done(double share) {
  const std::lock_guard lock(asking_);
  share_ = share;
  if (progress_ && !stopped_ && !progress_(share)) stopped_ = true;
  return stopped_;
}

Expected<PieceTimes> write_pieces(const PiecesToWrite& what, const fs::path& path,
                                  const WriteOptions& how, const MakeEncoder& make) {
  auto done = write_to(what, path, how, make);
  if (done || !done.error().where.empty()) return done;
  return Error{path == "-" ? "standard output" : path.string(), done.error().what};
}

}  // namespace mien
