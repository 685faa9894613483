// SPDX-License-Identifier: BSD-3-Clause

#include "stroma/output/pictures/CurveStyles.hpp"

#include <algorithm>
#include <array>

#include "stroma/base/Log.hpp"
#include "stroma/output/pictures/Gnuplot.hpp"
#include "stroma/output/pictures/PictureFile.hpp"

namespace stroma::output {
namespace {

using base::format;

constexpr int narrowest = 1000;                 // pixels of the picture
constexpr std::size_t letter = 9, sample = 90;  // pixels of a letter and of a line's sample

const std::array<const char*, 5> dashes = {"1", "(12,6)", "(3,4)", "(14,4,3,4)", "(24,6)"};
const std::array<int, 7> points = {7, 9, 6, 5, 11, 4, 13};

std::size_t letters_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string colour(std::size_t n, std::size_t of) {
  return of <= 6 ? line_colour(n) : viridis_colour(0.92 * static_cast<double>(n) / (of - 1.0));
}

/// By what a thing is told apart.
enum class Role { colour, dash, point };

struct Part {
  std::size_t thing;
  Role role;
};

/// The roles of the things that vary, in the order of the things; empty if they do not suffice.
std::vector<Part> roles(const std::vector<CurveThing>& things) {
  std::vector<Part> order;
  for (std::size_t t = 0; t < things.size(); ++t)
    if (things[t].alternatives.size() > 1) order.push_back({t, Role::colour});
  if (order.empty() || order.size() > 3) return {};
  const auto count = [&](const Part& one) { return things[one.thing].alternatives.size(); };
  std::stable_sort(order.begin(), order.end(),
                   [&](const Part& a, const Part& b) { return count(a) > count(b); });
  if (order.size() > 1) order[1].role = Role::dash;
  if (order.size() > 2) order[2].role = Role::point;
  for (const Part& one : order) {
    if (one.role == Role::dash && count(one) > dashes.size()) return {};
    if (one.role == Role::point && count(one) > points.size()) return {};
  }
  std::sort(order.begin(), order.end(),
            [](const Part& a, const Part& b) { return a.thing < b.thing; });
  return order;
}

/// Things and curves with the two things that have the fewest alternatives (but more than one) as
/// one: "specimen, grip" with "collagen only, clamped" and so on.
void merge_two(std::vector<CurveThing>& things, std::vector<CurveName>& curves) {
  std::vector<std::size_t> order;
  for (std::size_t t = 0; t < things.size(); ++t)
    if (things[t].alternatives.size() > 1) order.push_back(t);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return things[a].alternatives.size() < things[b].alternatives.size();
  });
  const std::size_t first = std::min(order[0], order[1]), second = std::max(order[0], order[1]);
  const CurveThing a = things[first], b = things[second];
  CurveThing both{a.name + ", " + b.name, {}};
  for (const std::string& one : a.alternatives)
    for (const std::string& other : b.alternatives) both.alternatives.push_back(one + ", " + other);
  things[first] = both;
  things[second].alternatives = {""};
  for (CurveName& curve : curves) {
    curve.alternative[first] =
        curve.alternative[first] * b.alternatives.size() + curve.alternative[second];
    curve.alternative[second] = 0;
  }
}

std::size_t varied(const std::vector<CurveThing>& things) {
  return static_cast<std::size_t>(
      std::count_if(things.begin(), things.end(),
                    [](const CurveThing& thing) { return thing.alternatives.size() > 1; }));
}

/// gnuplot takes letters for up to half as wide again as they are on the average; columns would be too wide.
std::string key_of(std::size_t rows, std::size_t longest) {
  return format(
      "set key below vertical left Left reverse maxrows %zu samplen 3 width %d title ' '\n", rows,
      3 - static_cast<int>(longest / 3));
}

/// A line of the legend for each curve. Many values of one thing are in order: so are their
/// colours.
CurveStyles listed(const std::vector<CurveName>& curves, bool is_one_thing) {
  CurveStyles styles;
  std::size_t longest = 1;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    longest = std::max(longest, letters_of(curves[c].name));
    const bool in_order = is_one_thing && curves.size() > 6;
    const std::string hue = in_order ? colour(c, curves.size()) : line_colour(c);
    const std::size_t dash = in_order ? 0 : c / 6 % dashes.size();
    styles.style.push_back(format("lw 2 dt %s pt %d ps 1 lc rgb '%s'", dashes[dash],
                                  points[c % points.size()], hue.c_str()));
    styles.title.push_back("title " + gnuplot_quoted(curves[c].name));
  }
  styles.width = std::max(narrowest, static_cast<int>(longest * letter + sample + 100));
  const std::size_t across = std::max<std::size_t>(
      1, static_cast<std::size_t>(styles.width - 100) / (longest * letter + sample));
  const std::size_t rows = std::max<std::size_t>(1, (curves.size() + across - 1) / across);
  styles.key = key_of(rows, longest);
  styles.key_lines = static_cast<int>(rows);
  return styles;
}

}  // namespace

CurveStyles curve_styles(std::vector<CurveThing> things, std::vector<CurveName> curves) {
  while (varied(things) > 3) merge_two(things, curves);
  const std::vector<Part> used = roles(things);
  if (used.size() < 2) return listed(curves, used.size() == 1);

  CurveStyles styles;
  const bool has_points = used.size() > 2;
  for (const CurveName& curve : curves) {
    std::string style = "lw 2";
    for (const auto& [thing, role] : used) {
      const std::size_t n = curve.alternative[thing];
      if (role == Role::colour)
        style += format(" lc rgb '%s'", colour(n, things[thing].alternatives.size()).c_str());
      if (role == Role::dash) style += format(" dt %s", dashes[n]);
      if (role == Role::point) style += format(" pt %d ps 1", points[n]);
    }
    styles.style.push_back(style + (has_points ? "" : " pt 7 ps 0.8"));
    styles.title.emplace_back("notitle");
  }
  std::size_t rows = 0, longest = 1;
  for (const auto& [thing, role] : used)
    rows = std::max(rows, 1 + things[thing].alternatives.size());
  const auto blank = [](const std::string& title) { return ", \\\n     keyentry title " + title; };
  for (const auto& [thing, role] : used) {
    styles.legend += blank(gnuplot_quoted(things[thing].name + ":"));
    const auto& alternatives = things[thing].alternatives;
    longest = std::max(longest, letters_of(things[thing].name) + 1);
    for (std::size_t n = 0; n < alternatives.size(); ++n) {
      longest = std::max(longest, letters_of(alternatives[n]));
      std::string look;
      if (role == Role::colour)
        look = format("lines lw 5 lc rgb '%s'", colour(n, alternatives.size()).c_str());
      if (role == Role::dash) look = format("lines lw 2 dt %s lc rgb '#222222'", dashes[n]);
      if (role == Role::point) look = format("points pt %d ps 1.3 lc rgb '#222222'", points[n]);
      styles.legend +=
          ", \\\n     keyentry with " + look + " title " + gnuplot_quoted(alternatives[n]);
    }
    for (std::size_t n = alternatives.size() + 1; n < rows; ++n) styles.legend += blank("' '");
  }
  styles.key = key_of(rows, longest);
  styles.key_lines = static_cast<int>(rows);
  styles.width =
      std::max(narrowest, static_cast<int>(used.size() * (longest * letter + sample) + 100));
  return styles;
}

}  // namespace stroma::output
