/// \file
/// NRRD, MetaImage and NIfTI through ITK. ITK reads raw MetaImage in parts; NRRD, NIfTI and
/// compressed MetaImage only as a whole, which rank 0 then does.

#include <itkImageIOBase.h>
#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "base/Log.hpp"
#include "image/HeaderUnits.hpp"
#include "image/ImageSource.hpp"
#include "image/LengthUnit.hpp"
#include "image/LibraryMessages.hpp"
#include "image/ValueExtent.hpp"

namespace stroma::image {
namespace {

using Component = itk::ImageIOBase::IOComponentType;
using Pixel = itk::ImageIOBase::IOPixelType;

std::optional<ValueType> value_type(Component component) {
  using Kind = ValueType::Kind;
  switch (component) {
    case itk::IOComponentEnum::UCHAR:
      return ValueType{Kind::unsigned_integer, 1};
    case itk::IOComponentEnum::CHAR:
      return ValueType{Kind::signed_integer, 1};
    case itk::IOComponentEnum::USHORT:
      return ValueType{Kind::unsigned_integer, 2};
    case itk::IOComponentEnum::SHORT:
      return ValueType{Kind::signed_integer, 2};
    case itk::IOComponentEnum::UINT:
      return ValueType{Kind::unsigned_integer, 4};
    case itk::IOComponentEnum::INT:
      return ValueType{Kind::signed_integer, 4};
    case itk::IOComponentEnum::ULONG:
    case itk::IOComponentEnum::ULONGLONG:
      return ValueType{Kind::unsigned_integer, 8};
    case itk::IOComponentEnum::LONG:
    case itk::IOComponentEnum::LONGLONG:
      return ValueType{Kind::signed_integer, 8};
    case itk::IOComponentEnum::FLOAT:
      return ValueType{Kind::floating, 4};
    case itk::IOComponentEnum::DOUBLE:
      return ValueType{Kind::floating, 8};
    default:
      return std::nullopt;
  }
}

class ItkSource : public ImageSource {
 public:
  explicit ItkSource(const ImageRequest& request) {
    summary_.path = request.path;
    summary_.channel = request.channel;
    itk::Object::GlobalWarningDisplayOff();
    make_reader();
    guarded([&] {
      reader_->SetFileName(request.path);
      reader_->ReadImageInformation();
    });
    take_size_and_type();
    check_channel(request.path, request.channel, summary_.channels);
    take_voxel_size();
  }

  bool readable_in_parts() const override { return streams_; }

  void read(const Box& box, double* values) override {
    const Box whole{{0, 0, 0}, summary_.file_size};
    const Box& loaded = streams_ ? box : whole;
    if (streams_ || bytes_.empty()) load(loaded);
    const std::int64_t channels = summary_.channels;
    for (std::int64_t k = 0; k < box.count[2]; ++k) {
      for (std::int64_t j = 0; j < box.count[1]; ++j) {
        const std::int64_t x = box.first[0] - loaded.first[0];
        const std::int64_t y = box.first[1] + j - loaded.first[1];
        const std::int64_t z = box.first[2] + k - loaded.first[2];
        const std::int64_t voxel = (z * loaded.count[1] + y) * loaded.count[0] + x;
        decode(bytes_.data() + (voxel * channels + summary_.channel) * summary_.type.bytes,
               summary_.type, false, box.count[0], channels,
               values + (k * box.count[1] + j) * box.count[0]);
      }
    }
    if (streams_) bytes_.clear();
  }

 private:
  void make_reader() {
    std::ifstream file(summary_.path, std::ios::binary);
    char head[5] = {};
    file.read(head, 4);
    if (std::string(head) == "NRRD") {
      reader_ = itk::NrrdImageIO::New();
      summary_.format = "NRRD";
    } else if (std::isalpha(static_cast<unsigned char>(head[0])) &&
               std::isalpha(static_cast<unsigned char>(head[1]))) {
      reader_ = itk::MetaImageIO::New();
      summary_.format = "MetaImage";
    } else {
      reader_ = itk::NiftiImageIO::New();
      summary_.format = "NIfTI";
    }
  }

  /// Runs a call of ITK; what it throws or prints becomes the reason of our error.
  void guarded(const std::function<void()>& call) {
    std::string reason;
    {
      const LibraryMessages messages;
      try {
        call();
        return;
      } catch (const itk::ExceptionObject& error) {
        reason = error.GetDescription();
      } catch (const std::exception& error) {
        reason = error.what();
      }
      const std::string printed = messages.text();
      if (!printed.empty()) reason += " " + printed;
    }
    for (char& c : reason) c = c == '\n' ? ' ' : c;
    if (reason.size() > 300) reason = reason.substr(0, 300) + " ...";
    refuse(summary_.path,
           "is a broken or truncated " + summary_.format + " file (ITK: " + reason + ")");
  }

  void take_size_and_type() {
    const std::string& path = summary_.path;
    const unsigned dimensions = reader_->GetNumberOfDimensions();
    for (unsigned d = 0; d < dimensions; ++d) {
      const auto count = static_cast<std::int64_t>(reader_->GetDimensions(d));
      if (d < 3) summary_.file_size[d] = count;
      if (d >= 3 && count != 1)
        refuse(path,
               base::format("has %u dimensions; admissible: 2 or 3 (and channels)", dimensions));
    }
    for (unsigned d = dimensions; d < 3; ++d) summary_.file_size[d] = 1;

    const auto type = value_type(reader_->GetComponentType());
    const Pixel pixel = reader_->GetPixelType();
    const bool plain = pixel == itk::IOPixelEnum::SCALAR || pixel == itk::IOPixelEnum::RGB ||
                       pixel == itk::IOPixelEnum::RGBA || pixel == itk::IOPixelEnum::VECTOR;
    if (!type || !plain) {
      refuse(path, "holds " + itk::ImageIOBase::GetPixelTypeAsString(pixel) + " values of type " +
                       itk::ImageIOBase::GetComponentTypeAsString(reader_->GetComponentType()) +
                       "; admissible: real values of one or more channels");
    }
    summary_.type = *type;
    summary_.channels = reader_->GetNumberOfComponents();
    check_size(path, summary_.file_size, summary_.channels, summary_.type.bytes, bytes_on_disk(),
               largest_expansion);
    require_all_values(path, summary_.format,
                       static_cast<std::uint64_t>(reader_->GetImageSizeInBytes()));
    streams_ = reader_->CanStreamRead() && dimensions == 3;
    if (streams_) reader_->SetUseStreamedReading(true);
  }

  /// Of the file, or, where a header has its values in files of their own, of all files of its
  /// folder.
  std::uint64_t bytes_on_disk() const {
    namespace fs = std::filesystem;
    const fs::path path = summary_.path;
    const std::string ending = path.extension().string();
    if (ending != ".mhd" && ending != ".nhdr" && ending != ".hdr") return fs::file_size(path);
    std::uint64_t total = 0;
    for (const auto& entry :
         fs::directory_iterator(path.has_parent_path() ? path.parent_path() : fs::path("."))) {
      if (entry.is_regular_file()) total += entry.file_size();
    }
    return total;
  }

  void take_voxel_size() {
    if (summary_.format == "NIfTI") return take_nifti_size();
    const HeaderUnits header =
        summary_.format == "NRRD" ? nrrd_units(summary_.path) : metaimage_units(summary_.path);
    const unsigned dimensions = std::min(reader_->GetNumberOfDimensions(), 3u);
    if (!header.has_spacing) return;
    if (!header.micrometres) {
      summary_.notes.push_back(
          base::format("the header's spacing (%g, %g, %g) has no unit of length; not used",
                       reader_->GetSpacing(0), dimensions > 1 ? reader_->GetSpacing(1) : 0.0,
                       dimensions > 2 ? reader_->GetSpacing(2) : 0.0));
      return;
    }
    for (unsigned d = 0; d < dimensions; ++d)
      set_spacing(d, reader_->GetSpacing(d) * *header.micrometres, summary_.format + " header");
  }

  /// ITK gives NIfTI's spacing in mm, from floats in the unit that the header names.
  void take_nifti_size() {
    std::string code;
    itk::ExposeMetaData<std::string>(reader_->GetMetaDataDictionary(), "xyzt_units", code);
    const int unit = std::atoi(code.c_str()) & 7;
    const unsigned dimensions = std::min(reader_->GetNumberOfDimensions(), 3u);
    if (unit < 1 || unit > 3) {
      summary_.notes.push_back("the NIfTI header does not name the unit of its spacing; not used");
      return;
    }
    for (unsigned d = 0; d < dimensions; ++d) {
      const double um = shortest_decimal(static_cast<float>(reader_->GetSpacing(d) * 1e3));
      set_spacing(d, um, "NIfTI header");
    }
  }

  void set_spacing(unsigned axis, double um, const std::string& place) {
    if (um > 0.0 && std::isfinite(um)) summary_.voxel_size.set(static_cast<int>(axis), um, place);
  }

  void load(const Box& box) {
    itk::ImageIORegion region(reader_->GetNumberOfDimensions());
    for (unsigned d = 0; d < reader_->GetNumberOfDimensions(); ++d) {
      region.SetIndex(d, d < 3 ? box.first[d] : 0);
      region.SetSize(d, d < 3 ? static_cast<itk::SizeValueType>(box.count[d]) : 1);
    }
    bytes_.assign(static_cast<std::size_t>(box.voxels() * summary_.channels * summary_.type.bytes),
                  0);
    guarded([&] {
      reader_->SetIORegion(region);
      reader_->Read(bytes_.data());
    });
  }

  itk::ImageIOBase::Pointer reader_;
  bool streams_ = false;
  std::vector<unsigned char> bytes_;
};

}  // namespace

std::unique_ptr<ImageSource> open_with_itk(const ImageRequest& request) {
  return std::make_unique<ItkSource>(request);
}

}  // namespace stroma::image
