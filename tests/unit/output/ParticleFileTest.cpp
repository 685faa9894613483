// SPDX-License-Identifier: BSD-3-Clause

/// \file
/// particles.e, read back with the Exodus library: values, names, counts, numbers, spread files.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>

#include "ParticleSample.hpp"
#include "TemporaryFolder.hpp"
#include "stroma/base/Error.hpp"
#include "stroma/output/files/ParticleFile.hpp"
#include "support/ExodusReader.hpp"

namespace stroma {
namespace {

using Sample = ParticleSample;

const std::vector<std::string> materials = {"collagen", "vessel",
                                            "a material with a name of over 32 letters"};
const std::vector<std::string> global_names = {"step", "load", "top.reaction_y"};
const output::Provenance provenance = {"gel, 10 %", "0.1.0",
                                       "<deck>\n\n" + std::string(100, 'x') + "\n</deck>\n"};

std::string own_file(const std::string& path) {
  const auto world = base::Communicator::world();
  return output::spread_file_name(path, world.size(), world.rank());
}

TEST(SpreadFileName, IsThatOfNemSpread) {
  EXPECT_EQ(output::spread_file_name("out/particles.e", 1, 0), "out/particles.e");
  EXPECT_EQ(output::spread_file_name("particles.e", 2, 1), "particles.e.2.1");
  EXPECT_EQ(output::spread_file_name("particles.e", 10, 3), "particles.e.10.03");
  EXPECT_EQ(output::spread_file_name("particles.e", 128, 127), "particles.e.128.127");
}

TEST(ParticleFile, HoldsTheParticlesAndTheirMaterials) {
  const TemporaryFolder folder;
  const Sample sample(50, 1000000000000);
  const output::ParticleFile file(base::Communicator::world(), folder / "p.e", sample.set,
                                  materials, global_names, provenance);
  const ExodusReader reader(own_file(folder / "p.e"));
  EXPECT_STREQ(reader.counts.title, "gel, 10 %");
  EXPECT_EQ(reader.counts.num_dim, 3);
  EXPECT_EQ(reader.counts.num_nodes, sample.set.count);
  EXPECT_EQ(reader.counts.num_elem, sample.set.count);
  EXPECT_EQ(reader.block_names(), materials);
  EXPECT_EQ(reader.word_bytes, 8);

  const auto x = reader.coordinates();
  const auto node_numbers = reader.numbers(EX_NODE_MAP);
  for (std::size_t p = 0; p < sample.id.size(); ++p) {
    EXPECT_EQ(node_numbers[p], sample.id[p] + 1);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(x[i][p], sample.position[3 * p + i]);
  }

  // Every particle stands once, in the block of its material, as a SPHERE on its own node.
  const auto element_numbers = reader.numbers(EX_ELEM_MAP);
  std::size_t element = 0;
  for (std::int64_t m = 0; m < 3; ++m) {
    const ExodusReader::Block block = reader.block(m + 1);
    if (block.elements > 0) {
      EXPECT_EQ(block.type, "SPHERE");
      EXPECT_EQ(block.nodes_each, 1);
      EXPECT_EQ(block.attributes, 2);
    }
    std::vector<double> radius(static_cast<std::size_t>(block.elements)), volume = radius;
    if (block.elements > 0) {
      EXPECT_GE(ex_get_one_attr(reader.id, EX_ELEM_BLOCK, m + 1, 1, radius.data()), 0);
      EXPECT_GE(ex_get_one_attr(reader.id, EX_ELEM_BLOCK, m + 1, 2, volume.data()), 0);
    }
    const auto nodes = reader.connectivity(m + 1);
    for (std::size_t e = 0; e < nodes.size(); ++e, ++element) {
      const auto p = static_cast<std::size_t>(nodes[e] - 1);
      EXPECT_EQ(sample.material[p], m);
      EXPECT_EQ(element_numbers[element], sample.id[p] + 1);
      EXPECT_EQ(volume[e], sample.volume[p]);
      EXPECT_NEAR(4.0 / 3.0 * std::acos(-1.0) * std::pow(radius[e], 3), sample.volume[p],
                  1e-13 * sample.volume[p]);
    }
  }
  EXPECT_EQ(element, sample.id.size());
}

TEST(ParticleFile, HoldsEveryStepAtOnceReadable) {
  const TemporaryFolder folder;
  const Sample sample(50, 1000000000000);
  output::ParticleFile file(base::Communicator::world(), folder / "p.e", sample.set, materials,
                            global_names, provenance);
  EXPECT_EQ(ExodusReader(own_file(folder / "p.e")).steps(), 0);
  for (int step = 1; step <= 3; ++step) {
    const double load = 0.1 * step;
    file.write(load, sample.set, sample.in_pieces(), {1.0 * step, load, -1.0 / 3.0});
    // The writer is alive and in the middle of its run, as if it were killed now.
    const ExodusReader reader(own_file(folder / "p.e"));
    ASSERT_EQ(reader.steps(), step);
    EXPECT_EQ(reader.time(step), load);
    EXPECT_EQ(reader.variables(EX_GLOBAL), global_names);
    EXPECT_EQ(reader.globals(step), (std::vector<double>{1.0 * step, load, -1.0 / 3.0}));
  }
  EXPECT_EQ(file.steps(), 3);

  const ExodusReader reader(own_file(folder / "p.e"));
  const std::vector<std::string> variables = {
      "displacement_x",     "displacement_y",     "displacement_z",
      "von_mises",          "stress_xx",          "stress_yy",
      "stress_zz",          "stress_xy",          "stress_yz",
      "stress_zx",          "strain_xx",          "strain_yy",
      "strain_zz",          "strain_xy",          "strain_yz",
      "strain_zx",          "jacobian",           "strain_energy_density",
      "principal_stress_1", "principal_stress_2", "principal_stress_3"};
  EXPECT_EQ(reader.variables(EX_ELEM_BLOCK), variables);
  if (sample.set.count == 0) return;

  const std::string axis[3] = {"_x", "_y", "_z"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto u = reader.variable(2, EX_NODAL, "displacement" + axis[i], 1, sample.set.count);
    for (std::size_t p = 0; p < u.size(); ++p) EXPECT_EQ(u[p], sample.displacement[3 * p + i]);
  }
  for (std::int64_t m = 1; m <= 2; ++m) {
    const auto nodes = reader.connectivity(m);
    const auto values = [&](const std::string& name) {
      return reader.variable(2, EX_ELEM_BLOCK, name, m, static_cast<std::int64_t>(nodes.size()));
    };
    const auto jacobian = values("jacobian"), energy = values("strain_energy_density");
    const auto von_mises = values("von_mises"), u_z = values("displacement_z");
    const int rows[] = {0, 1, 2, 0, 1, 2}, columns[] = {0, 1, 2, 1, 2, 0};
    std::vector<std::vector<double>> s, strain, principal;
    for (const char* ij : {"xx", "yy", "zz", "xy", "yz", "zx"})
      strain.push_back(values(std::string("strain_") + ij));
    for (const char* ij : {"xx", "yy", "zz", "xy", "yz", "zx"})
      s.push_back(values(std::string("stress_") + ij));
    for (const char* i : {"1", "2", "3"})
      principal.push_back(values(std::string("principal_stress_") + i));
    for (std::size_t e = 0; e < nodes.size(); ++e) {
      const auto p = static_cast<std::size_t>(nodes[e] - 1);
      EXPECT_EQ(jacobian[e], sample.jacobian[p]);
      EXPECT_EQ(energy[e], sample.energy[p]);
      EXPECT_EQ(u_z[e], sample.displacement[3 * p + 2]);
      for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(s[i][e], sample.stress[6 * p + i]);

      // E = (F^T F - I) / 2.
      for (std::size_t c = 0; c < 6; ++c) {
        const int i = rows[c], j = columns[c];
        double product = 0.0;
        for (int k = 0; k < 3; ++k) {
          const auto F = [&](int a, int b) {
            return sample.gradient[9 * p + static_cast<std::size_t>(3 * a + b)] + (a == b);
          };
          product += F(k, i) * F(k, j);
        }
        EXPECT_NEAR(strain[c][e], 0.5 * (product - (i == j)), 1e-14);
      }

      // The principal values are in order and have the tensor's trace and second invariant; von
      // Mises stress follows from them alone.
      const double s1 = principal[0][e], s2 = principal[1][e], s3 = principal[2][e];
      EXPECT_GE(s1, s2);
      EXPECT_GE(s2, s3);
      EXPECT_NEAR(s1 + s2 + s3, s[0][e] + s[1][e] + s[2][e], 1e-11);
      const double squares = s[0][e] * s[0][e] + s[1][e] * s[1][e] + s[2][e] * s[2][e] +
                             2 * (s[3][e] * s[3][e] + s[4][e] * s[4][e] + s[5][e] * s[5][e]);
      EXPECT_NEAR(s1 * s1 + s2 * s2 + s3 * s3, squares, 1e-13 * squares);
      const double expected =
          std::sqrt(0.5 * ((s1 - s2) * (s1 - s2) + (s2 - s3) * (s2 - s3) + (s3 - s1) * (s3 - s1)));
      EXPECT_NEAR(von_mises[e], expected, 1e-12 * expected);
    }
  }
}

// More particles than one buffer holds: the pieces must join without a seam.
TEST(ParticleFile, WritesBlocksLongerThanTheBuffer) {
  const TemporaryFolder folder;
  const Sample sample(2 * output::ExodusFile::piece + 17);
  output::ParticleFile file(base::Communicator::world(), folder / "p.e", sample.set, materials,
                            global_names, provenance);
  file.write(1.0, sample.set, sample.in_pieces(), {0, 0, 0});
  const ExodusReader reader(own_file(folder / "p.e"));
  const auto element_numbers = reader.numbers(EX_ELEM_MAP);
  std::size_t element = 0, wrong = 0;
  for (std::int64_t m = 1; m <= 3; ++m) {
    const auto nodes = reader.connectivity(m);
    const auto stress =
        reader.variable(1, EX_ELEM_BLOCK, "stress_yz", m, static_cast<std::int64_t>(nodes.size()));
    for (std::size_t e = 0; e < nodes.size(); ++e, ++element) {
      const auto p = static_cast<std::size_t>(nodes[e] - 1);
      if (element_numbers[element] != sample.id[p] + 1 || stress[e] != sample.stress[6 * p + 4])
        ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(element, sample.id.size());
}

TEST(ParticleFile, SinglePrecisionHasFourByteNumbers) {
  const TemporaryFolder folder;
  const Sample sample(50);
  output::ParticleFile file(base::Communicator::world(), folder / "p.e", sample.set, materials,
                            global_names, provenance, output::Precision::Single);
  file.write(0.1, sample.set, sample.in_pieces(), {1, 2, 1.0 / 3.0});
  const ExodusReader reader(own_file(folder / "p.e"));
  EXPECT_EQ(reader.word_bytes, 4);
  EXPECT_EQ(reader.globals(1)[2], static_cast<double>(1.0F / 3.0F));
  const auto nodes = reader.connectivity(1);
  const auto jacobian =
      reader.variable(1, EX_ELEM_BLOCK, "jacobian", 1, static_cast<std::int64_t>(nodes.size()));
  for (std::size_t e = 0; e < nodes.size(); ++e) {
    const auto p = static_cast<std::size_t>(nodes[e] - 1);
    EXPECT_EQ(jacobian[e], static_cast<double>(static_cast<float>(sample.jacobian[p])));
  }
}

TEST(ParticleFile, KeepsVersionAndDeck) {
  const TemporaryFolder folder;
  const Sample sample(5);
  const output::ParticleFile file(base::Communicator::world(), folder / "p.e", sample.set,
                                  materials, global_names, provenance);
  const ExodusReader reader(own_file(folder / "p.e"));
  ASSERT_EQ(ex_inquire_int(reader.id, EX_INQ_INFO), 5);
  char lines[5][MAX_LINE_LENGTH + 1];
  char* info[5] = {lines[0], lines[1], lines[2], lines[3], lines[4]};
  ASSERT_GE(ex_get_info(reader.id, info), 0);
  EXPECT_STREQ(info[0], "<deck>");
  EXPECT_STREQ(info[1], "");
  EXPECT_EQ(std::string(info[2]) + info[3], std::string(100, 'x'));
  EXPECT_STREQ(info[4], "</deck>");
  ASSERT_EQ(ex_inquire_int(reader.id, EX_INQ_QA), 1);
  char words[4][MAX_STR_LENGTH + 1];
  char* qa[1][4] = {{words[0], words[1], words[2], words[3]}};
  ASSERT_GE(ex_get_qa(reader.id, qa), 0);
  EXPECT_STREQ(qa[0][0], "Stroma");
  EXPECT_STREQ(qa[0][1], "0.1.0");
}

TEST(ParticleFile, SpreadFilesKnowTheWhole) {
  const auto world = base::Communicator::world();
  if (world.size() == 1) GTEST_SKIP() << "one rank writes one plain file";
  const TemporaryFolder folder;
  const Sample sample(50);
  const output::ParticleFile file(world, folder / "p.e", sample.set, materials, global_names,
                                  provenance);
  const ExodusReader reader(own_file(folder / "p.e"));
  int ranks = 0, in_file = 0;
  char kind[2] = "";
  ASSERT_GE(ex_get_init_info(reader.id, &ranks, &in_file, kind), 0);
  EXPECT_EQ(ranks, world.size());
  EXPECT_EQ(in_file, 1);
  EXPECT_EQ(kind[0], 'p');
  std::int64_t nodes = 0, elements = 0, blocks = 0, node_sets = 0, side_sets = 0;
  ASSERT_GE(ex_get_init_global(reader.id, &nodes, &elements, &blocks, &node_sets, &side_sets), 0);
  EXPECT_EQ(nodes, 50 * (world.size() - 1));
  EXPECT_EQ(elements, nodes);
  EXPECT_EQ(blocks, 3);
  std::int64_t ids[3] = {}, counts[3] = {};
  ASSERT_GE(ex_get_eb_info_global(reader.id, ids, counts), 0);
  const std::int64_t even_ranks = world.size() / 2;  // among those with particles
  EXPECT_EQ(counts[1], 17 * even_ranks);
  EXPECT_EQ(counts[0], nodes - 17 * even_ranks);
  EXPECT_EQ(counts[2], 0);
  for (std::int64_t b = 0; b < 3; ++b) EXPECT_EQ(ids[b], b + 1);
  std::int64_t inside = 0, border = 0, outside = 0, inside_e = 0, border_e = 0, maps = 0,
               maps_e = 0;
  ASSERT_GE(ex_get_loadbal_param(reader.id, &inside, &border, &outside, &inside_e, &border_e, &maps,
                                 &maps_e, world.rank()),
            0);
  EXPECT_EQ(inside, sample.set.count);
  EXPECT_EQ(inside_e, sample.set.count);
  EXPECT_EQ(border + outside + border_e + maps + maps_e, 0);
}

TEST(ParticleFile, CannotBeCreatedIsARunErrorOnEveryRank) {
  const TemporaryFolder folder;
  const Sample sample(5);
  const std::string path = folder / "missing/p.e";
  const std::string message = message_of<base::RunError>([&] {
    output::ParticleFile(base::Communicator::world(), path, sample.set, materials, global_names,
                         provenance);
  });
  EXPECT_EQ(message, "cannot create '" +
                         output::spread_file_name(path, base::Communicator::world().size(), 0) +
                         "': No such file or directory");
}

TEST(ParticleFile, AParticleOfAnUnknownMaterialIsARunErrorOnEveryRank) {
  const TemporaryFolder folder;
  Sample sample(5);
  if (base::Communicator::world().is_root()) sample.material[0] = 3;
  EXPECT_THROW(output::ParticleFile(base::Communicator::world(), folder / "p.e", sample.set,
                                    materials, global_names, provenance),
               base::RunError);
}

/// While it lives, files of this process cannot grow beyond a size: what a full disk does.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit old_{};
  void (*handler_)(int) = nullptr;
};

// The disk of rank 0 fills up in the middle of a step; all ranks learn of it, and of the file.
/// A file of one step.
struct Begun {
  explicit Begun(std::int64_t count) : sample(count) {
    file.write(0.1, sample.set, sample.in_pieces(), {1, 0.1, 0});
  }

  const TemporaryFolder folder;
  const base::Communicator world = base::Communicator::world();
  const Sample sample;
  output::ParticleFile file{world, folder / "p.e", sample.set, materials, global_names, provenance};
  const std::string path = own_file(folder / "p.e");
};

TEST(ParticleFile, ADiskThatFillsUpIsARunErrorOnEveryRank) {
  Begun begun(20000);
  const TemporaryFolder& folder = begun.folder;
  const base::Communicator& world = begun.world;
  const Sample& sample = begun.sample;
  output::ParticleFile& file = begun.file;
  const std::string& path = begun.path;
  std::string message;
  {
    const rlim_t full = static_cast<rlim_t>(std::filesystem::file_size(path)) + 100000;
    const SmallDisk disk(world.is_root() ? full : RLIM_INFINITY);
    message = message_of<base::RunError>([&] {
      file.write(0.2, sample.set, sample.in_pieces(), {2, 0.2, 0});
    });
  }
  EXPECT_NE(message.find(output::spread_file_name(folder / "p.e", world.size(), 0)),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("File too large"), std::string::npos) << message;
  EXPECT_EQ(file.steps(), 1);

  // What was computed before is still there.
  const ExodusReader reader(path);
  EXPECT_EQ(reader.steps(), 1);
  EXPECT_EQ(reader.time(1), 0.1);
  const auto nodes = reader.connectivity(1);
  const auto jacobian =
      reader.variable(1, EX_ELEM_BLOCK, "jacobian", 1, static_cast<std::int64_t>(nodes.size()));
  for (std::size_t e = 0; e < nodes.size(); ++e) {
    EXPECT_EQ(jacobian[e], sample.jacobian[static_cast<std::size_t>(nodes[e] - 1)]);
  }

  // And goes on once there is room.
  file.write(0.2, sample.set, sample.in_pieces(), {2, 0.2, 0});
  EXPECT_EQ(ExodusReader(path).steps(), 2);
  EXPECT_EQ(ExodusReader(path).time(2), 0.2);
}

// V-RESTART-5.
TEST(ParticleFile, AStepBecomesVisibleOnlyWhenItIsWhole) {
  Begun begun(20000);
  const Sample& sample = begun.sample;
  output::ParticleFile& file = begun.file;
  const std::string& path = begun.path;
  bool was_asked = false;
  file.write(0.2, sample.set,
             [&](const auto& use) {
               sample.in_pieces()(use);  // the variables are written
               EXPECT_EQ(ExodusReader(path).steps(), 1);
               EXPECT_EQ(ExodusReader(path).time(1), 0.1);
               was_asked = true;
             },
             {2, 0.2, 0});
  EXPECT_TRUE(was_asked);
  EXPECT_EQ(ExodusReader(path).steps(), 2);
}

TEST(ParticleFile, IsCutAndContinued) {
  const TemporaryFolder folder;
  const auto world = base::Communicator::world();
  const Sample sample(2000);
  const std::string path = own_file(folder / "p.e");
  output::FileEnd end;
  {
    output::ParticleFile file(world, folder / "p.e", sample.set, materials, global_names,
                              provenance);
    file.write(0.1, sample.set, sample.in_pieces(), {1, 0.1, 0});
    end = file.end();
    file.write(0.2, sample.set, sample.in_pieces(), {2, 0.2, 0});
    file.write(0.3, sample.set, sample.in_pieces(), {3, 0.3, 0});
  }
  EXPECT_EQ(end.steps, 1);
  EXPECT_EQ(output::end_of(path).steps, 3);
  output::ParticleFile file(world, folder / "p.e", sample.set, materials, global_names, provenance,
                            output::Precision::Double, {}, end);
  EXPECT_EQ(output::end_of(path).bytes, end.bytes);
  file.write(0.25, sample.set, sample.in_pieces(), {2, 0.25, 7});
  const ExodusReader reader(path);
  ASSERT_EQ(reader.steps(), 2);
  EXPECT_EQ(reader.time(1), 0.1);
  EXPECT_EQ(reader.time(2), 0.25);
  EXPECT_EQ(reader.globals(2), (std::vector<double>{2, 0.25, 7}));
  EXPECT_FALSE(output::cut_at(path, {3, 1000}));  // it does not go as far
  EXPECT_THROW(output::end_of(folder / "none.e"), base::RunError);
}

}  // namespace
}  // namespace stroma
