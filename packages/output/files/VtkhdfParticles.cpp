// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/files/VtkhdfParticles.hpp"

#include <algorithm>

#include "stroma/base/Error.hpp"

namespace stroma::output {
namespace {

/// A column of the file, and the variable of particles.e that is its first component.
struct Field {
  VtkhdfColumn column;
  std::size_t first;
};

/// Columns of what a step changes: components in a row are one.
std::vector<Field> fields_of(const std::vector<ParticleVariable>& variables) {
  static const std::vector<std::string> parts{"displacement", "stress", "strain"};
  std::vector<Field> all;
  for (std::size_t v = 0; v < variables.size(); ++v) {
    const std::string& name = variables[v].name;
    const std::string stem = name.substr(0, name.find('_'));
    const bool is_part = std::count(parts.begin(), parts.end(), stem) > 0 &&
                         name.find_first_not_of("xyz", stem.size() + 1) == std::string::npos;
    if (is_part && !all.empty() && all.back().column.name == stem) {
      ++all.back().column.components;
    } else {
      all.push_back({{is_part ? stem : name, variables[v].unit}, v});
    }
  }
  return all;
}

/// What no step changes.
struct Fixed {
  VtkhdfColumn column;
  double (*value)(const ParticleSet&, std::int64_t);
};

const std::vector<Fixed>& fixed_columns() {
  using Set = ParticleSet;
  static const std::vector<Fixed> all{
      {{"id", "-", 1, VtkhdfColumn::Number::integer},
       [](const Set& set, std::int64_t p) { return static_cast<double>(set.id[p] + 1); }},
      {{"material", "-", 1, VtkhdfColumn::Number::byte},
       [](const Set& set, std::int64_t p) { return set.material[p] + 1.0; }},
      {{"radius", "um"}, [](const Set& set, std::int64_t p) { return radius_of(set.volume[p]); }},
      {{"volume", "um^3"}, [](const Set& set, std::int64_t p) { return set.volume[p]; }}};
  return all;
}

/// Calls use(first, count) for consecutive ranges from `begin` to `end`.
template <class Use>
void in_ranges(std::int64_t begin, std::int64_t end, const Use& use) {
  for (std::int64_t first = begin; first < end; first += ExodusFile::piece)
    use(first, std::min(ExodusFile::piece, end - first));
}

void put_fixed(const VtkhdfPieces& file, const ParticleSet& particles, std::size_t before) {
  std::vector<std::int64_t> points;
  std::vector<double> values;
  in_ranges(0, particles.count, [&](std::int64_t first, std::int64_t count) {
    file.points(first, count, particles.position + 3 * first);
    points.resize(static_cast<std::size_t>(count));
    values.resize(points.size());
    for (std::size_t n = 0; n < points.size(); ++n)
      points[n] = first + static_cast<std::int64_t>(n);
    file.cells(first, count, points.data());
    for (std::size_t c = 0; c < fixed_columns().size(); ++c) {
      for (std::size_t n = 0; n < points.size(); ++n)
        values[n] = fixed_columns()[c].value(particles, points[n]);
      file.column(before + c, first, count, values.data());
    }
  });
}

void put_states(const VtkhdfPieces& file, const StatePieces& states,
                const std::vector<ParticleVariable>& variables, const std::vector<Field>& fields) {
  std::vector<double> values;  // (field) (particle, component)
  states([&](std::int64_t first_of_state, std::int64_t of_state, const ParticleState& state) {
    in_ranges(0, of_state, [&](std::int64_t first, std::int64_t count) {
      values.resize(static_cast<std::size_t>(count) * variables.size());
      const auto begin_of = [&](const Field& field) {
        return values.data() + static_cast<std::size_t>(count) * field.first;
      };
      for (std::int64_t n = 0; n < count; ++n) {
        const ParticleAt particle(state, first + n);
        for (const Field& field : fields)
          for (int c = 0; c < field.column.components; ++c)
            begin_of(field)[n * field.column.components + c] =
                variables[field.first + static_cast<std::size_t>(c)].value(particle);
      }
      for (std::size_t f = 0; f < fields.size(); ++f)
        file.column(f, first_of_state + first, count, begin_of(fields[f]));
    });
  });
}

}  // namespace

void write_vtkhdf_particles(const base::Communicator& communicator, const std::string& path,
                            const ParticleSet& particles, const StatePieces& states,
                            const std::vector<ShownField>& fields,
                            const std::vector<VtkhdfNumber>& numbers, Precision precision) {
  const std::vector<ParticleVariable> variables = particle_variables(fields);
  const std::vector<Field> changing = fields_of(variables);
  std::vector<VtkhdfColumn> columns;
  for (const Field& field : changing) columns.push_back(field.column);
  for (const Fixed& fixed : fixed_columns()) columns.push_back(fixed.column);
  write_vtkhdf(communicator, path, {VtkCell::vertex, particles.count, particles.count}, columns,
               numbers, precision, [&](const VtkhdfPieces& file) {
                 put_fixed(file, particles, changing.size());
                 put_states(file, states, variables, changing);
               });
}

}  // namespace stroma::output
