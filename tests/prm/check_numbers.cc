// SPDX-License-Identifier: LGPL-2.1-or-later

// Compares named numbers of a run with references:
//   check_numbers RUN/summary.json CASE.expected
//     lines "json/pointer value tolerance  # source", relative tolerance, or
//     absolute where the value is 0;
//     "at-most json/pointer value  # reason";
//     "history COLUMN TIME value tolerance  # source": from history.csv,
//     linear between steps;
//     "mean COLUMN FROM TO value tolerance  # source": of the steps between;
//     "balance tolerance POINTER POINTER ...  # reason": the sum over the
//     largest;
//     "ripple COLUMN FROM TO limit  # reason": largest less smallest deviation
//     from the best parabola between two times, over the mean
//   check_numbers RUN/summary.json OTHER/summary.json TOLERANCE [any-steps]
//     forces, penetrations, probes, reactions and counts of two runs

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

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

  /// A column of history.csv and the times.
  void
  read_history(const std::string   &summary,
               const std::string   &column,
               std::vector<double> &times,
               std::vector<double> &values)
  {
    std::ifstream in(summary.substr(0, summary.find_last_of('/') + 1) +
                     "history.csv");
    std::string   line, cell;
    std::getline(in, line);
    int                time_at = -1, value_at = -1, i = 0;
    std::istringstream head(line);
    while (std::getline(head, cell, ','))
      {
        if (cell == "time")
          time_at = i;
        if (cell == column)
          value_at = i;
        ++i;
      }
    if (time_at < 0 || value_at < 0)
      {
        std::cerr << "no column " << column << " in history.csv" << std::endl;
        std::exit(1);
      }
    while (std::getline(in, line))
      {
        std::istringstream  row(line);
        std::vector<double> numbers;
        while (std::getline(row, cell, ','))
          numbers.push_back(std::stod(cell));
        times.push_back(numbers.at(time_at));
        values.push_back(numbers.at(value_at));
      }
  }

  double
  value_at(const std::vector<double> &times,
           const std::vector<double> &values,
           const double               time)
  {
    for (std::size_t i = 1; i < times.size(); ++i)
      if (times[i] >= time - 1e-9 * time)
        {
          const double s = (time - times[i - 1]) / (times[i] - times[i - 1]);
          return (1. - s) * values[i - 1] + s * values[i];
        }
    std::cerr << "history.csv ends before time " << time << std::endl;
    std::exit(1);
  }

  /// See "ripple" above.
  double
  ripple(const std::vector<double> &times,
         const std::vector<double> &values,
         const double               from,
         const double               to)
  {
    // normal equations of the parabola
    double              A[3][4] = {};
    double              mean    = 0.;
    std::vector<double> s, v;
    for (std::size_t i = 0; i < times.size(); ++i)
      if (times[i] >= from && times[i] <= to)
        {
          s.push_back((times[i] - from) / (to - from));
          v.push_back(values[i]);
          mean += values[i];
        }
    if (s.size() < 8)
      {
        std::cerr << "too few steps for a ripple" << std::endl;
        std::exit(1);
      }
    mean /= s.size();
    for (std::size_t i = 0; i < s.size(); ++i)
      for (int r = 0; r < 3; ++r)
        {
          for (int c = 0; c < 3; ++c)
            A[r][c] += std::pow(s[i], r + c);
          A[r][3] += std::pow(s[i], r) * v[i];
        }
    for (int r = 0; r < 3; ++r)
      for (int k = 0; k < 3; ++k)
        if (k != r)
          for (int c = 3; c >= 0; --c)
            A[k][c] -= (c >= r) ? A[k][r] / A[r][r] * A[r][c] : 0.;
    double low = 1e300, high = -1e300;
    for (std::size_t i = 0; i < s.size(); ++i)
      {
        const double fit = A[0][3] / A[0][0] + A[1][3] / A[1][1] * s[i] +
                           A[2][3] / A[2][2] * s[i] * s[i];
        low  = std::min(low, v[i] - fit);
        high = std::max(high, v[i] - fit);
      }
    return (high - low) / std::abs(mean);
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
          ++count;
          if (pointer == "at-most")
            {
              in >> pointer >> value;
              const double found =
                summary.at(nlohmann::json::json_pointer("/" + pointer))
                  .get<double>();
              const bool fine = in && found <= value;
              std::cout << (fine ? "ok     " : "FAILED ") << pointer << ": "
                        << found << ", at most " << value << std::endl;
              ok = ok && fine;
              continue;
            }
          if (pointer == "mean")
            {
              std::string         column;
              double              from, to;
              std::vector<double> times, values;
              if (!(in >> column >> from >> to >> value >> tolerance))
                {
                  std::cerr << "unreadable line: " << line << std::endl;
                  return 1;
                }
              read_history(argv[1], column, times, values);
              double       sum = 0.;
              unsigned int n   = 0;
              for (std::size_t i = 0; i < times.size(); ++i)
                if (times[i] >= from && times[i] <= to)
                  {
                    sum += values[i];
                    ++n;
                  }
              ok = close("mean of " + column,
                         sum / n,
                         value,
                         tolerance * (value == 0. ? 1. : std::abs(value))) &&
                   ok;
              continue;
            }
          if (pointer == "balance")
            {
              double      sum = 0., largest = 0.;
              std::string term;
              in >> tolerance;
              while (in >> term && term[0] != '#')
                {
                  const double force =
                    summary.at(nlohmann::json::json_pointer("/" + term))
                      .get<double>();
                  sum += force;
                  largest = std::max(largest, std::abs(force));
                }
              ok = close("balance", sum / largest, 0., tolerance) && ok;
              continue;
            }
          if (pointer == "history" || pointer == "ripple")
            {
              std::string         column;
              double              first, second, third;
              std::vector<double> times, values;
              if (!(in >> column >> first >> second >> third))
                {
                  std::cerr << "unreadable line: " << line << std::endl;
                  return 1;
                }
              read_history(argv[1], column, times, values);
              if (pointer == "history")
                ok = close(column + " at " + std::to_string(first),
                           value_at(times, values, first),
                           second,
                           third * (second == 0. ? 1. : std::abs(second))) &&
                     ok;
              else
                ok = close("ripple of " + column,
                           ripple(times, values, first, second),
                           0.,
                           third) &&
                     ok;
              continue;
            }
          if (!(in >> value >> tolerance))
            {
              std::cerr << "unreadable line: " << line << std::endl;
              return 1;
            }
          const double found =
            summary.at(nlohmann::json::json_pointer("/" + pointer))
              .get<double>();
          ok = close(pointer,
                     found,
                     value,
                     tolerance * (value == 0. ? 1. : std::abs(value))) &&
               ok;
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
