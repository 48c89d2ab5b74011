// SPDX-License-Identifier: LGPL-2.1-or-later
#include "suggestion.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace Structure
{
  namespace
  {
    /// Where names occur: paths of sections, "" at the top level.
    using Places = std::map<std::string, std::set<std::string>>;

    struct Declared
    {
      Places entries, sections;
    };

    /// ParameterHandler shows its tree as text only.
    Declared
    names_in(const ParameterHandler &prm)
    {
      std::stringstream text;
      prm.print_parameters(text, ParameterHandler::ShortText);
      Declared                 declared;
      std::vector<std::string> path;
      for (std::string line; std::getline(text, line);)
        {
          line             = Utilities::trim(line);
          const auto after = [&](const std::string &word) {
            return Utilities::trim(line.substr(word.size()));
          };
          std::string here;
          for (const std::string &section : path)
            here += (here.empty() ? "" : "/") + section;
          if (line == "end")
            path.pop_back();
          else if (line.rfind("subsection ", 0) == 0)
            {
              path.push_back(after("subsection "));
              declared.sections[path.back()].insert(here);
            }
          else if (line.rfind("set ", 0) == 0)
            {
              const std::string entry = after("set ");
              declared
                .entries[Utilities::trim(entry.substr(0, entry.find('=')))]
                .insert(here);
            }
        }
      return declared;
    }

    /// Fewest letters to insert, remove, replace or exchange with the next one
    /// (optimal string alignment), upper case or not.
    unsigned int
    distance(const std::string &a, const std::string &b)
    {
      const auto same = [](const char x, const char y) {
        return std::tolower(static_cast<unsigned char>(x)) ==
               std::tolower(static_cast<unsigned char>(y));
      };
      std::vector<std::vector<unsigned int>> d(
        a.size() + 1, std::vector<unsigned int>(b.size() + 1));
      for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j)
          if (i == 0 || j == 0)
            d[i][j] = i + j;
          else
            {
              d[i][j] = std::min(
                {d[i - 1][j] + 1,
                 d[i][j - 1] + 1,
                 d[i - 1][j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
              if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) &&
                  same(a[i - 2], b[j - 1]))
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
      return d.back().back();
    }

    /// The part of @p text between two others; empty where they are not there.
    std::string
    between(const std::string &text,
            const std::string &before,
            const std::string &after)
    {
      const std::size_t start = text.find(before);
      if (start == std::string::npos)
        return {};
      const std::size_t from = start + before.size();
      return text.substr(from, text.find(after, from) - from);
    }

    /// Entries that are known by other names to users of LS-DYNA, see
    /// doc/ls_dyna_names.md.
    std::string
    entry_of_field(const std::string &field)
    {
      static const std::map<std::string, std::string> entries = {
        {"SURFA", "Secondary"},
        {"SSID", "Secondary"},
        {"SURFB", "Primary"},
        {"MSID", "Primary"},
        {"SFS", "Stiffness scale"},
        {"SFSA", "Stiffness scale"},
        {"SLSFAC", "Penalty factor"},
        {"IGAP", "Progressive stiffening"},
        {"PENMAX", "Largest penetration"},
        {"IGNORE", "Initial penetration"},
        {"MPAR1", "Removal time' (IGNORE = 3, 4) or 'Initial pressure"},
        {"MPAR2", "Deepest initial penetration"},
        {"FS", "Friction coefficient"},
        {"FD", "Dynamic friction coefficient"},
        {"DC", "Friction decay"},
        {"VC", "Friction function"},
        {"SST", "Thickness"},
        {"SAST", "Thickness"},
        {"SFST", "Thickness scale"},
        {"SLDTHK", "Secondary offset"},
        {"NFLS", "Normal strength"},
        {"SFLS", "Shear strength"},
        {"MINFO", "Penetration report every"},
        {"DT0", "First step"},
        {"DTMIN", "Smallest step"},
        {"DTMAX", "Largest step"},
        {"ITEOPT", "Target iterations"},
        {"ILIMIT", "Maximum iterations"},
        {"DCTOL", "Displacement tolerance"},
        {"RCTOL", "Force tolerance"}};
      std::string upper = field;
      for (char &c : upper)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      const auto entry = entries.find(upper);
      return entry == entries.end() ? "" : entry->second;
    }

    std::string
    sentence(const Places &names, const std::string &wrong)
    {
      // at most one letter in three is wrong
      unsigned int              best = 1 + wrong.size() / 3;
      const Places::value_type *near = nullptr;
      for (const auto &name : names)
        if (best > 0 && name.first.rfind(wrong + " ", 0) == 0)
          {
            best = 0;
            near = &name;
          }
        else if (const unsigned int d = distance(name.first, wrong); d < best)
          {
            best = d;
            near = &name;
          }
      if (near == nullptr)
        return {};

      constexpr std::size_t most = 3;
      std::string           places;
      std::size_t           n = 0;
      for (const std::string &place : near->second)
        if (n++ < most)
          places += (places.empty() ? "" : ", ") +
                    (place.empty() ? "the top level" : "'" + place + "'");
      if (near->second.size() > most)
        places += " and others";
      return (near->first == wrong ?
                "\nThere is a '" + wrong + "' in " :
                "\nDid you mean '" + near->first + "'? It belongs in ") +
             places + ".";
    }
  } // namespace


  std::string
  did_you_mean(const ParameterHandler &prm, const std::string &error)
  {
    const std::string entry = between(error, "No entry with name <", ">");
    if (const std::string here = entry_of_field(entry); !here.empty())
      return "\n" + entry + " of LS-DYNA is '" + here +
             "' here, see doc/ls_dyna_names.md.";
    if (!entry.empty())
      return sentence(names_in(prm).entries, entry);
    std::string section = Utilities::trim(
      between(error, "no such subsection to be entered: ", "\n"));
    while (!section.empty() && section.back() == '.')
      section.pop_back();
    if (section.empty())
      return {};
    const std::size_t dot  = section.rfind('.');
    const std::string last = section.substr(dot + 1);
    const std::string near = sentence(names_in(prm).sections, last);
    // bodies, conditions, interfaces and the like are listed
    const std::string outer = section.substr(0, dot);
    const bool        is_listed =
      dot != std::string::npos &&
      (outer == "Bodies" || outer == "Boundary conditions" ||
       outer == "Contact" || outer == "Rigid bodies" || outer == "Probes");
    return near + (is_listed ?
                     "\nIs '" + last + "' missing in '" + outer + "/" +
                       (outer == "Contact" ? "Interfaces" : "Names") + "'?" :
                     "");
  }
} // namespace Structure
