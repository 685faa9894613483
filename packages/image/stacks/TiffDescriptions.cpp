// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/image/stacks/TiffDescriptions.hpp"

#include <cstring>

#include "stroma/base/Log.hpp"

namespace stroma::image {
namespace {

long long printable(std::int64_t number) { return static_cast<long long>(number); }

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else if (c == '"')
      xml += "&quot;";
    else if (static_cast<unsigned char>(c) >= ' ')
      xml += c;
  }
  return xml;
}

/// NAME="17 digits" NAMEUnit="um"
std::string length(const std::string& name, double um) {
  return base::format(" %s=\"%.17g\" %sUnit=\"&#181;m\"", name.c_str(), um, name.c_str());
}

std::string axes(const std::string& name, const std::array<double, 3>& um) {
  return length(name + "X", um[0]) + length(name + "Y", um[1]) + length(name + "Z", um[2]);
}

}  // namespace

std::string ome_xml(const StackHeader& header) {
  const auto channels = static_cast<std::int64_t>(header.channels.size());
  const std::string schema = "http://www.openmicroscopy.org/Schemas/OME/2016-06";
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OME xmlns=\"" + schema +
      "\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xsi:schemaLocation=\"" + schema +
      " " + schema + "/ome.xsd\" Creator=\"" + escaped(header.creator) + "\">\n";
  xml += "<Image ID=\"Image:0\" Name=\"" + escaped(header.name) + "\">\n";
  xml += base::format(
      "<Pixels ID=\"Pixels:0\" DimensionOrder=\"XYCZT\" Type=\"float\" BigEndian=\"false\" "
      "SizeX=\"%lld\" SizeY=\"%lld\" SizeZ=\"%lld\" SizeC=\"%lld\" SizeT=\"1\"",
      printable(header.size[0]), printable(header.size[1]), printable(header.size[2]),
      printable(channels));
  xml += axes("PhysicalSize", header.voxel_size) + ">\n";
  for (std::int64_t c = 0; c < channels; ++c)
    xml +=
        base::format("<Channel ID=\"Channel:0:%lld\" SamplesPerPixel=\"1\" Name=\"", printable(c)) +
        escaped(header.channels[static_cast<std::size_t>(c)].name) + "\"/>\n";
  xml += base::format("<TiffData IFD=\"0\" PlaneCount=\"%lld\"/>\n",
                      printable(channels * header.size[2]));
  xml += "<Plane TheZ=\"0\" TheT=\"0\" TheC=\"0\"" + axes("Position", header.origin) + "/>\n";
  return xml + "</Pixels>\n</Image>\n</OME>";
}

std::string imagej_description(const StackHeader& header) {
  const auto channels = static_cast<std::int64_t>(header.channels.size());
  std::string text = base::format("ImageJ=1.53t\nimages=%lld\nchannels=%lld\nslices=%lld\n",
                                  printable(channels * header.size[2]), printable(channels),
                                  printable(header.size[2]));
  if (channels > 1) text += "hyperstack=true\nmode=grayscale\n";
  text += base::format("unit=micron\nspacing=%.17g\n", header.voxel_size[2]);
  for (std::size_t axis = 0; axis < 3; ++axis)  // voxel that the image's origin lies in
    text += base::format("%corigin=%.9g\n", "xyz"[axis],
                         -header.origin[axis] / header.voxel_size[axis]);
  return text + "loop=false\n";
}

ImageJLabels imagej_labels(const StackHeader& header) {
  const auto append = [](std::vector<unsigned char>& bytes, auto number) {
    const std::size_t end = bytes.size();
    bytes.resize(end + sizeof number);
    std::memcpy(bytes.data() + end, &number, sizeof number);
  };
  const auto pages = static_cast<std::uint32_t>(header.channels.size()) *
                     static_cast<std::uint32_t>(header.size[2]);
  ImageJLabels labels;
  for (const std::uint32_t word : {0x494a494au, 0x6c61626cu, pages})  // "IJIJ", "labl"
    append(labels.bytes, word);
  labels.byte_counts.push_back(static_cast<std::uint32_t>(labels.bytes.size()));
  for (std::int64_t k = 0; k < header.size[2]; ++k)
    for (const StackChannel& channel : header.channels) {
      for (const char c : channel.name) append(labels.bytes, static_cast<std::uint16_t>(c));
      labels.byte_counts.push_back(2 * static_cast<std::uint32_t>(channel.name.size()));
    }
  return labels;
}

}  // namespace stroma::image
