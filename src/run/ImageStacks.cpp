// SPDX-License-Identifier: BSD-3-Clause

#include "run/ImageStacks.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "stroma/base/Error.hpp"
#include "stroma/base/Log.hpp"
#include "stroma/base/Stage.hpp"
#include "stroma/output/OutputFiles.hpp"
#include "stroma/output/files/ProgramFacts.hpp"

namespace stroma {
namespace {

constexpr const char* label = "label";

/// The variables of these names; a label's has no value of a particle's state.
std::vector<output::ParticleVariable> variables_of(const std::vector<std::string>& names) {
  const std::vector<output::ParticleVariable> all = output::particle_variables();
  std::vector<output::ParticleVariable> chosen;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    chosen.push_back(found == all.end() ? output::ParticleVariable{name, "-", {}} : *found);
  }
  return chosen;
}

}  // namespace

ImageStacks::ImageStacks(const base::Communicator& communicator, const Deck& deck,
                         const Specimen& specimen, const output::RunFolder& folder)
    : communicator_(communicator),
      deck_(&deck),
      folder_(folder),
      size_(specimen.image.size),
      voxel_size_(specimen.image.voxel_size.um),
      shares_(deck.parameters.particles, specimen.body, size_, voxel_size_) {
  for (std::size_t d = 0; d < 3; ++d) origin_[d] = specimen.body.origin[d];
  if (deck.parameters.output.image_stacks)
    quantities_ = variables_of(deck.parameters.output.image_stacks->quantities);
}

void ImageStacks::resume(std::int64_t last_step) const {
  namespace fs = std::filesystem;
  const auto& wanted = deck_->parameters.output.image_stacks;
  if (!wanted || wanted->every == 0) return;
  base::collectively(communicator_, [&] {
    if (!communicator_.is_root()) return;
    for (const bool is_deformed : output::are_deformed(*wanted))
      for (const auto& entry : fs::directory_iterator(folder_.folder())) {
        const std::string file = entry.path().filename().string();
        const std::size_t number = file.find("-s");
        if (number == std::string::npos) continue;
        const long long step = std::atoll(file.c_str() + number + 2);
        std::error_code failure;
        if (step > last_step && file == output::image_stack_file(*wanted, is_deformed, step))
          fs::remove_all(entry.path(), failure);
        if (failure) throw base::RunError(file + ": cannot be removed: " + failure.message());
      }
  });
}

void ImageStacks::write_due(const output::HistoryRow& row, const mechanics::Body& body,
                            const grid::Vector& u) {
  const auto& wanted = deck_->parameters.output.image_stacks;
  if (wanted && output::is_due(row.step, wanted->every, false)) write(row, body, u);
}

void ImageStacks::write_last(const output::HistoryRow& row, const mechanics::Body& body,
                             const grid::Vector& u) {
  if (deck_->parameters.output.image_stacks && step_ != row.step) write(row, body, u);
}

void ImageStacks::write(const output::HistoryRow& row, const mechanics::Body& body,
                        const grid::Vector& u) {
  const base::Stage stage("image stacks");
  for (const bool is_deformed : output::are_deformed(*deck_->parameters.output.image_stacks))
    write_frame(is_deformed, row,
                PlacedParticles(communicator_, body, u, shares_, voxel_size_, is_deformed));
  step_ = row.step;
}

void ImageStacks::write_frame(bool is_deformed, const output::HistoryRow& row,
                              PlacedParticles particles) const {
  const output::ImageStacksParameters& wanted = *deck_->parameters.output.image_stacks;
  const voxels::Box box =
      is_deformed ? particles.of_body().voxels(0.5) : voxels::Box{{0, 0, 0}, size_};
  const image::StackHeader head = header(is_deformed, row, box);
  const std::string path = folder_.file(output::image_stack_file(wanted, is_deformed, row.step));
  const auto writer = wanted.format == image::StackFormat::ome_tiff
                          ? image::tiff_stack(communicator_, path, head, wanted.compression)
                          : image::zarr_stack(communicator_, path, head, wanted.compression);

  std::vector<voxels::Rule> rules;
  for (const image::StackChannel& channel : head.channels)
    rules.push_back(channel.is_label ? voxels::Rule::largest : voxels::Rule::mean);
  voxels::Box reach = particles.of_rank().voxels();
  for (std::size_t d = 0; d < 3; ++d) reach.first[d] -= box.first[d];
  const auto& materials = deck_->parameters.materials.materials;
  std::vector<double> values(rules.size());
  const std::int64_t band = image::planes_of_band(head);
  for (std::int64_t first = 0; first < box.count[2]; first += band) {
    const std::int64_t planes = std::min(band, box.count[2] - first);
    voxels::BandMeans means(communicator_, box.count, first, planes, reach, rules);
    particles.visit(
        box.first[2] + first, planes,
        [&](voxels::FilledBox filled, const output::ParticleAt& particle, std::size_t material) {
          for (std::size_t d = 0; d < 3; ++d) {
            filled.low[d] -= static_cast<double>(box.first[d]);
            filled.high[d] -= static_cast<double>(box.first[d]);
          }
          if (!means.is_reached_by(filled)) return;
          for (std::size_t q = 0; q < values.size(); ++q)
            values[q] = quantities_[q].value ? quantities_[q].value(particle)
                                             : materials[material].second.label;
          means.add(filled, values.data());
        });
    writer->write(first, means.values());
  }
  writer->finish();
}

image::StackHeader ImageStacks::header(bool is_deformed, const output::HistoryRow& row,
                                       const voxels::Box& box) const {
  image::StackHeader head;
  const std::string& title = deck_->parameters.title;
  head.name = title + (title.empty() ? "" : ", ") +
              base::format("step %lld, load %.6g, %s", static_cast<long long>(row.step), row.load,
                           is_deformed ? "deformed" : "undeformed");
  head.creator = "Stroma " + output::program_version();
  head.size = box.count;
  head.voxel_size = voxel_size_;
  for (std::size_t d = 0; d < 3; ++d)
    head.origin[d] = origin_[d] + static_cast<double>(box.first[d]) * voxel_size_[d];
  for (const output::ParticleVariable& quantity : quantities_)
    head.channels.push_back(
        {quantity.name + (quantity.unit == "-" ? "" : " [" + quantity.unit + "]"),
         quantity.name == label});
  return head;
}

}  // namespace stroma
