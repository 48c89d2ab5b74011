// SPDX-License-Identifier: LGPL-2.1-or-later

// Compares named numbers of a run with references:
//   check_numbers RUN/summary.json CASE.expected
//     lines "json/pointer value tolerance  # source", relative tolerance
//   check_numbers RUN/summary.json OTHER/summary.json TOLERANCE [any-steps]
//     forces, penetrations, probes, reactions and counts of two runs

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace
{
  nlohmann::json
  read(const std::string &file)
  {
    std::ifstream in(file);
    if (!in)
      {
        std::cerr << "cannot open " << file << std::endl;
        std::exit(1);
      }
    return nlohmann::json::parse(in);
  }

  bool
  close(const std::string &name,
        const double       found,
        const double       expected,
        const double       allowed)
  {
    const bool ok = std::abs(found - expected) <= allowed;
    std::cout << (ok ? "ok     " : "FAILED ") << name << ": " << found
              << ", expected " << expected << " +- " << allowed << std::endl;
    return ok;
  }

  /// All numbers below @p a in @p b, relative to the largest of each group.
  bool
  same(const std::string    &name,
       const nlohmann::json &a,
       const nlohmann::json &b,
       const double          tolerance)
  {
    const nlohmann::json left = a.flatten(), right = b.flatten();
    double               largest = 0.;
    for (const auto &[key, value] : left.items())
      if (value.is_number())
        largest = std::max(largest, std::abs(value.get<double>()));
    bool ok = true;
    for (const auto &[key, value] : left.items())
      if (value.is_number())
        ok = close(name + key,
                   value.get<double>(),
                   right.at(key).get<double>(),
                   tolerance * largest) &&
             ok;
    return ok;
  }
} // namespace

int
main(int argc, char **argv)
{
  std::cout.precision(17);
  bool ok    = true;
  int  count = 0;
  if (argc == 3)
    {
      const nlohmann::json summary = read(argv[1]);
      std::ifstream        expected(argv[2]);
      std::string          line;
      while (std::getline(expected, line))
        {
          std::istringstream in(line);
          std::string        pointer;
          double             value, tolerance;
          if (!(in >> pointer) || pointer[0] == '#')
            continue;
          if (!(in >> value >> tolerance))
            {
              std::cerr << "unreadable line: " << line << std::endl;
              return 1;
            }
          const double found =
            summary.at(nlohmann::json::json_pointer("/" + pointer))
              .get<double>();
          ok = close(pointer, found, value, tolerance * std::abs(value)) && ok;
          ++count;
        }
    }
  else if (argc == 4 || argc == 5)
    {
      const nlohmann::json a = read(argv[1]), b = read(argv[2]);
      const double         tolerance = std::stod(argv[3]);
      if (argc == 4)
        ok = close("steps", a["steps"], b["steps"], 0.) && ok;
      for (const auto &[name, interface] : a["interfaces"].items())
        for (const char *key :
             {"force", "largest_penetration", "active_area", "energy"})
          {
            nlohmann::json left, right;
            left["v"]  = interface[key];
            right["v"] = b["interfaces"][name][key];
            ok         = same(name + ":" + key, left, right, tolerance) && ok;
            ++count;
          }
      for (const char *group : {"probes", "reactions"})
        if (a.contains(group))
          ok = same(group, a[group], b[group], tolerance) && ok;
    }
  if (count == 0)
    {
      std::cerr << "nothing was compared" << std::endl;
      return 1;
    }
  return ok ? 0 : 1;
}
