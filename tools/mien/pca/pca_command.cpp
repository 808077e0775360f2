// mien pca: finds, describes, applies and draws bases of animations.

#include <mien/npy_basis.h>
#include "lib/base/watch.h"
#include "render/image/file/written_file.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/cli/option_words.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/output/contact_sheet.h"
#include "tools/mien/pca/frames.h"
#include "tools/mien/pca/pictures.h"
#include "tools/mien/terminal/interrupt.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/progress_display.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace mien::command {
namespace {

/// A value, or the exit code after the error has been printed.
template <class T>
std::optional<T> aloud(Expected<T> value, int& code, ExitCode wrong = kFailed) {
  if (value) return *std::move(value);
  code = complain(value.error(), wrong);
  return {};
}

Expected<PcaWish> read_wish(const PcaArguments& arguments) {
  PcaWish wish;
  const int asked = int(arguments.components.has_value()) + int(arguments.variance.has_value()) +
                    int(arguments.max_error.has_value());
  if (asked != 1)
    return Error{"pca fit", "one of --components, --variance and --max-error is needed"};
  if (arguments.components) {
    const auto count = read_whole("--components", *arguments.components, 1, 1'000'000'000);
    if (!count) return count.error();
    wish.count = std::size_t(*count);
  }
  if (arguments.variance) {
    const auto share = read_real("--variance", *arguments.variance, 0, 1);
    if (!share) return share.error();
    wish.variance = *share;
  }
  if (arguments.max_error) {
    const auto most = read_real("--max-error", *arguments.max_error, 0, 1e300);
    if (!most) return most.error();
    wish.max_error = *most;
  }
  return wish;
}

std::string size_text(const BasisFile& file) {
  const double ratio = double(file.bytes_before()) / double(file.bytes_after());
  return fmt::format(
      "{} frames of {} x {} numbers, {}: {} bytes\n"
      "mean, {} components, {} weights: {} bytes, 1/{:.4g} of that\n",
      file.frames, file.vertices, file.dimensions, file.single ? "float32" : "float64",
      file.bytes_before(), file.fit.basis.count, file.frames * file.fit.basis.count,
      file.bytes_after(), ratio);
}

std::string curve_text(const std::vector<PcaError>& curve) {
  std::string text = "components  variance      rms error     max error     at frame, vertex\n";
  for (const PcaError& e : curve)
    text += fmt::format("{:10}  {:<12.8f}  {:<12.6g}  {:<12.6g}  {}, {}\n", e.count, e.variance,
                        e.rms, e.max, e.frame, e.vertex);
  return text;
}

int save_picture(const Image& image, const std::string& path) {
  const auto done = write_image_by(load_encoder, image, path, {});
  return done ? kDone : complain(done.error(), kFailed);
}

/// The basis with where its frames come from.
BasisFile basis_file(PcaFit fit, const PcaFrames& frames) {
  BasisFile file{std::move(fit), frames.source.rows, frames.vertices, frames.dimensions,
                 frames.single};
  if (frames.face) {
    set_face(file, *frames.face);
    file.fps = frames.fps;
    file.begin = double(frames.range.first) / frames.fps;
  }
  return file;
}

int fit(const PcaArguments& arguments) {
  int code = kDone;
  const auto wish = aloud(read_wish(arguments), code, kUsedWrongly);
  if (!wish) return code;
  auto read = read_pca_frames(arguments);
  if (!read.frames) return read.code;
  PcaFrames& frames = *read.frames;
  watch_interrupts();
  ProgressDisplay display;
  PcaOptions options{.vertices = std::move(frames.groups),
                     .single = frames.single,
                     .progress = display.watch("fit")};
  auto fitted = fit_pca(frames.source, *wish, options);
  if (interrupted()) {
    complain("interrupted", kFailed);
    die_of_interrupt();
  }
  if (!fitted)
    return complain(
        fitted.error().where.empty() ? Error{arguments.input, fitted.error().what} : fitted.error(),
        kFailed);
  const BasisFile file = basis_file(*std::move(fitted), frames);
  const auto done =
      write_file(arguments.output, [&](const PutBytes& put) { return write_basis(put, file); });
  if (!done) return complain(done.error(), kFailed);
  if (arguments.output == "-") return kDone;
  const PcaError& last = file.fit.curve.back();
  return print(size_text(file) + fmt::format("variance {:.8f}, rms error {:.6g}, max error {:.6g} "
                                             "(frame {}, vertex {})\n",
                                             last.variance, last.rms, last.max, last.frame,
                                             last.vertex));
}

int info(const PcaArguments& arguments) {
  int code = kDone;
  const auto file = aloud(read_basis(arguments.basis), code);
  if (!file) return code;
  if (arguments.plot) {
    const int drawn = save_picture(curve_picture(file->fit.curve, 960, 600), *arguments.plot);
    if (drawn != kDone) return drawn;
  }
  const std::string of_face = file->slices.empty()
                                  ? ""
                                  : fmt::format("of the face {} at {:.6g} frames/s from {:.6g} s\n",
                                                file->face, file->fps, file->begin);
  return print(of_face + size_text(*file) + curve_text(file->fit.curve));
}

/// The same numbers, whose reading is watched. They are read block by block, mostly once.
MatrixSource watched(const MatrixSource& source, const std::string& phase) {
  const auto work = std::make_shared<WatchedWork>(phase);
  const double all = double(std::max<std::size_t>(source.rows * source.columns, 1));
  const auto read = [=, done = 0.0](const MatrixBlock& block, double* out) mutable {
    auto got = source.read(block, out);
    done += double(block.rows * block.columns) / all;
    work->at(std::min(done, 1.0));
    return got;
  };
  return {source.rows, source.columns, read};
}

int encode(const PcaArguments& arguments) {
  int code = kDone;
  const auto file = aloud(read_basis(arguments.basis), code);
  if (!file) return code;
  const auto read = read_pca_frames(arguments);
  if (!read.frames) return read.code;
  auto weights = encode_pca(file->fit.basis, watched(read.frames->source, "encode"));
  if (!weights)
    return complain(weights.error().where.empty() ? Error{arguments.input, weights.error().what}
                                                  : weights.error(),
                    kFailed);
  const std::size_t shape[] = {read.frames->source.rows, file->fit.basis.count};
  const auto done = write_file(arguments.output, [&](const PutBytes& put) {
    return write_npy(put, file->single ? NpyType::float32 : NpyType::float64, shape,
                     matrix_in_memory(*weights, shape[0], shape[1]));
  });
  return done ? kDone : complain(done.error(), kFailed);
}

int decode(const PcaArguments& arguments) {
  int code = kDone;
  const auto file = aloud(read_basis(arguments.basis), code);
  if (!file) return code;
  std::vector<double> weights = file->fit.weights;
  if (arguments.weights) {
    const auto given = aloud(FrameFile::open(*arguments.weights), code);
    if (!given) return code;
    const MatrixSource source = given->source();
    if (source.columns != file->fit.basis.count)
      return complain(Error{*arguments.weights,
                            fmt::format("has {} weights a frame, the basis has {} components",
                                        source.columns, file->fit.basis.count)},
                      kFailed);
    weights.resize(source.rows * source.columns);
    if (const auto got = source.read({0, source.rows, 0, source.columns}, weights.data()); !got)
      return complain(got.error(), kFailed);
  }
  const std::size_t shape[] = {weights.size() / file->fit.basis.count, file->vertices,
                               file->dimensions};
  const auto done = write_file(arguments.output, [&](const PutBytes& put) {
    return write_npy(
        put, file->single ? NpyType::float32 : NpyType::float64, shape,
        watched(decoded_frames(file->fit.basis, weights, file->fit.basis.count, file->single),
                "decode"));
  });
  return done ? kDone : complain(done.error(), kFailed);
}

/// The error of every vertex in one frame, as a share of the largest.
std::vector<double> vertex_amounts(const std::vector<double>& a, const std::vector<double>& b,
                                   const VertexGroups& groups, double largest) {
  std::vector<double> amounts(groups.count());
  for (std::size_t v = 0; v < groups.count(); ++v) {
    double square = 0;
    for (std::size_t i = groups.begin[v]; i < groups.begin[v + 1]; ++i)
      square += (a[i] - b[i]) * (a[i] - b[i]);
    amounts[v] = largest > 0 ? groups.scale[v] * std::sqrt(square) / largest : 0;
  }
  return amounts;
}

int draw_comparison(const PcaArguments& arguments, const BasisFile& file, const PcaFrames& frames,
                    const MatrixSource& decoded, const FrameDifference& found) {
  int code = kDone;
  long frame = long(found.all.frame);
  if (arguments.frame) {
    const auto wanted =
        aloud(read_whole("--frame", *arguments.frame, 0, long(frames.source.rows) - 1), code,
              kUsedWrongly);
    if (!wanted) return code;
    frame = *wanted;
  }
  auto painter = aloud(FramePainter::of(arguments, file, frames.face), code, kUsedWrongly);
  if (!painter) return code;
  std::vector<double> a(frames.source.columns), b(a.size());
  const MatrixBlock row{std::size_t(frame), 1, 0, a.size()};
  if (const auto got = frames.source.read(row, a.data()); !got)
    return complain(got.error(), kFailed);
  if (const auto got = decoded.read(row, b.data()); !got) return complain(got.error(), kFailed);
  painter->include(a);
  painter->include(b);
  std::vector<Image> pictures{captioned(painter->paint(a), fmt::format("frame {}", frame)),
                              captioned(painter->paint(b), "reconstruction")};
  if (painter->is_face()) {
    const Image drawn = painter->paint(a), again = painter->paint(b);
    const LevelDifference levels = level_difference(drawn, again);
    const int told = print(fmt::format("frame {} as drawn: rms {:.4f}, max {} levels of 255\n",
                                       frame, levels.rms, levels.max));
    if (told != kDone) return told;
    pictures.push_back(captioned(difference_picture(drawn, again, std::max(levels.max, 1)),
                                 fmt::format("difference to {} levels", levels.max)));
  } else {
    const double largest = found.frame_max[std::size_t(frame)];
    pictures.push_back(
        captioned(painter->paint_heat(a, vertex_amounts(a, b, frames.groups, largest)),
                  fmt::format("error to {:.3g}", largest)));
  }
  return save_picture(contact_sheet(pictures, 3, 8), arguments.output);
}

int compare(const PcaArguments& arguments) {
  int code = kDone;
  const auto file = aloud(read_basis(arguments.basis), code);
  if (!file) return code;
  const auto read = read_pca_frames(arguments);
  if (!read.frames) return read.code;
  const PcaFrames& frames = *read.frames;
  const PcaBasis& basis = file->fit.basis;
  auto weights = encode_pca(basis, watched(frames.source, "encode"));
  if (!weights)
    return complain(weights.error().where.empty() ? Error{arguments.input, weights.error().what}
                                                  : weights.error(),
                    kFailed);
  if (file->single)
    for (double& weight : *weights) weight = double(float(weight));
  const MatrixSource decoded = decoded_frames(basis, *weights, basis.count, file->single);
  const auto found =
      aloud(compare_frames(watched(frames.source, "compare"), decoded, frames.groups), code);
  if (!found) return code;
  const int told =
      print(fmt::format("rms error {:.6g}, max error {:.6g} (frame {}, vertex {})\n",
                        found->all.rms, found->all.max, found->all.frame, found->all.vertex));
  if (told != kDone || arguments.output.empty()) return told;
  return draw_comparison(arguments, *file, frames, decoded, *found);
}

/// The mean, then each component from − to + in a row of three.
int sheet(const PcaArguments& arguments) {
  int code = kDone;
  const auto file = aloud(read_basis(arguments.basis), code);
  if (!file) return code;
  double spread = 2;
  if (arguments.spread) {
    const auto wanted =
        aloud(read_real("--spread", *arguments.spread, 0, 1000), code, kUsedWrongly);
    if (!wanted) return code;
    spread = *wanted;
  }
  auto painter = aloud(FramePainter::of(arguments, *file, {}), code, kUsedWrongly);
  if (!painter) return code;
  constexpr std::size_t kMostRows = 16;
  const PcaBasis& basis = file->fit.basis;
  std::vector<std::vector<double>> frames;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(basis.count, kMostRows); ++i)
    for (const double sign : {-1.0, 0.0, 1.0}) {
      std::vector<double> frame = basis.mean;
      const double by = sign * spread * std::sqrt(basis.variances[i]);
      for (std::size_t c = 0; c < basis.columns; ++c) frame[c] += by * basis.component(i)[c];
      painter->include(frame);
      frames.push_back(std::move(frame));
      words.push_back(sign == 0 ? fmt::format("component {}", i + 1)
                                : fmt::format("{:.3g} sd", sign * spread));
    }
  std::vector<Image> pictures;
  WatchedWork work("pictures", frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i, work.step())
    pictures.push_back(captioned(painter->paint(frames[i]), words[i]));
  return save_picture(contact_sheet(pictures, 3, 8), arguments.output);
}

}  // namespace

int pca_command(const PcaArguments& arguments) {
  using Verb = PcaArguments::Verb;
  switch (arguments.verb) {
    case Verb::fit:
      return fit(arguments);
    case Verb::info:
      return info(arguments);
    case Verb::encode:
      return encode(arguments);
    case Verb::decode:
      return decode(arguments);
    case Verb::compare:
      return compare(arguments);
    case Verb::sheet:
      return sheet(arguments);
  }
  return kUsedWrongly;
}

}  // namespace mien::command
