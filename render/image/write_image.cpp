#include <mien/write.h>
#include "lib/base/memory_ran_out.h"
#include "render/image/file_type.h"
#include "render/image/oiio/oiio_encoder.h"
#include "render/image/png/png_encoder.h"
#include "render/image/tiff/tiff_encoder.h"
#include "render/image/write_pieces.h"

namespace mien {
namespace {

MadeEncoder make_encoder(const EncoderRequest& request) {
  const PictureWriter writer = format_of(request.type).writer;
  return writer == PictureWriter::png    ? png_encoder(request)
         : writer == PictureWriter::tiff ? tiff_encoder(request)
                                         : oiio_encoder(request);
}

}  // namespace

Expected<Done> write_image(const Image& image, const std::filesystem::path& path,
                           const WriteOptions& how) try {
  return write_image_by(make_encoder, image, path, how);
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

Expected<PictureStats> write_picture(const Scene& scene, const View& view,
                                     const std::filesystem::path& path,
                                     const PictureOptions& how) try {
  return write_picture_by(make_encoder, scene, view, path, how);
} catch (const std::bad_alloc&) {
  return memory_ran_out(path.native());
}

}  // namespace mien
