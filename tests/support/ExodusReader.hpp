// SPDX-License-Identifier: BSD-3-Clause

#pragma once

/// \file
/// Reads an Exodus file back with the Exodus library alone, independently of Stroma's writers.

#include <exodusII.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace stroma {

class ExodusReader {
 public:
  explicit ExodusReader(const std::string& path) {
    ex_opts(0);
    int memory_bytes = 8;
    float version = 0;
    id = ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &memory_bytes, &word_bytes, &version);
    EXPECT_GE(id, 0) << path;
    ex_set_max_name_length(id, 255);
    EXPECT_GE(ex_get_init_ext(id, &counts), 0) << path;
  }
  ~ExodusReader() { ex_close(id); }
  ExodusReader(const ExodusReader&) = delete;
  ExodusReader& operator=(const ExodusReader&) = delete;

  int steps() const { return static_cast<int>(ex_inquire_int(id, EX_INQ_TIME)); }

  double time(int step) const {
    double value = -1;
    EXPECT_GE(ex_get_time(id, step, &value), 0);
    return value;
  }

  std::vector<std::string> variables(ex_entity_type type) const {
    int count = 0;
    EXPECT_GE(ex_get_variable_param(id, type, &count), 0);
    return names(count, [&](char** list) { return ex_get_variable_names(id, type, count, list); });
  }

  std::vector<std::string> block_names() const {
    const int count = static_cast<int>(counts.num_elem_blk);
    return names(count, [&](char** list) { return ex_get_names(id, EX_ELEM_BLOCK, list); });
  }

  std::vector<double> globals(int step) const {
    std::vector<double> values(variables(EX_GLOBAL).size());
    EXPECT_GE(ex_get_var(id, step, EX_GLOBAL, 1, 1, static_cast<std::int64_t>(values.size()),
                         values.data()),
              0);
    return values;
  }

  /// A variable by its name, on a block (or the nodes: block 1).
  std::vector<double> variable(int step, ex_entity_type type, const std::string& name,
                               std::int64_t block, std::int64_t count) const {
    const std::vector<std::string> all = variables(type);
    int index = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i] == name) index = static_cast<int>(i) + 1;
    }
    EXPECT_GT(index, 0) << "no variable " << name;
    std::vector<double> values(static_cast<std::size_t>(count));
    if (count > 0) {
      EXPECT_GE(ex_get_var(id, step, type, index, block, count, values.data()), 0) << name;
    }
    return values;
  }

  std::array<std::vector<double>, 3> coordinates() const {
    const auto n = static_cast<std::size_t>(counts.num_nodes);
    std::array<std::vector<double>, 3> x{std::vector<double>(n), std::vector<double>(n),
                                         std::vector<double>(n)};
    if (n > 0) {
      EXPECT_GE(ex_get_coord(id, x[0].data(), x[1].data(), x[2].data()), 0);
    }
    return x;
  }

  std::vector<std::int64_t> numbers(ex_entity_type map) const {
    const std::int64_t count = (map == EX_NODE_MAP) ? counts.num_nodes : counts.num_elem;
    std::vector<std::int64_t> values(static_cast<std::size_t>(count));
    if (count > 0) {
      EXPECT_GE(ex_get_id_map(id, map, values.data()), 0);
    }
    return values;
  }

  struct Block {
    std::string type;
    std::int64_t elements = 0;
    std::int64_t nodes_each = 0;
    std::int64_t attributes = 0;
  };
  Block block(std::int64_t block_id) const {
    char type[MAX_STR_LENGTH + 1] = "";
    Block block;
    std::int64_t edges = 0, faces = 0;
    EXPECT_GE(ex_get_block(id, EX_ELEM_BLOCK, block_id, type, &block.elements, &block.nodes_each,
                           &edges, &faces, &block.attributes),
              0);
    block.type = type;
    return block;
  }

  std::vector<std::int64_t> connectivity(std::int64_t block_id) const {
    const Block shape = block(block_id);
    std::vector<std::int64_t> nodes(static_cast<std::size_t>(shape.elements * shape.nodes_each));
    if (!nodes.empty()) {
      EXPECT_GE(ex_get_conn(id, EX_ELEM_BLOCK, block_id, nodes.data(), nullptr, nullptr), 0);
    }
    return nodes;
  }

  int id = -1;
  int word_bytes = 0;
  ex_init_params counts{};

 private:
  template <class Get>
  std::vector<std::string> names(int count, const Get& get) const {
    std::vector<std::vector<char>> buffers(static_cast<std::size_t>(count),
                                           std::vector<char>(256, '\0'));
    std::vector<char*> list;
    for (auto& buffer : buffers) list.push_back(buffer.data());
    if (count > 0) {
      EXPECT_GE(get(list.data()), 0);
    }
    return {list.begin(), list.end()};
  }
};

}  // namespace stroma
