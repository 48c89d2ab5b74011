// SPDX-License-Identifier: LGPL-2.1-or-later
#include "gmsh_check.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <fstream>
#include <sstream>

namespace Structure
{
  using namespace dealii;

  void
  check_gmsh(const std::string &file)
  {
    std::ifstream in(file);
    std::string   line, section;
    // lines of the file, where the section began, entries in it
    unsigned long number = 0, first = 0, entries = 0, announced = 0;
    bool          is_old = true; // format 2: an entry is a line
    const auto    fail   = [&](const std::string &what) {
      AssertThrow(false,
                  ExcMessage("'Mesh/File' is '" + file + "': " + what + "."));
    };
    while (std::getline(in, line))
      {
        ++number;
        line                = Utilities::trim(line);
        const bool is_count = section == "Nodes" || section == "Elements";
        if (line == "$NOD") // format 1
          return;
        if (line.empty())
          continue;
        if (section.empty())
          {
            if (line[0] == '$')
              {
                section = line.substr(1);
                first   = number;
                entries = 0;
              }
          }
        else if (line == "$End" + section)
          {
            if (is_old && is_count && entries != announced + 1)
              fail("'$" + section + "' in line " + std::to_string(first) +
                   " announces " + std::to_string(announced) +
                   " entries; there are " +
                   std::to_string(entries == 0 ? 0 : entries - 1));
            if (section == "Elements")
              return; // nothing behind is read
            section.clear();
          }
        else if (++entries == 1)
          {
            std::istringstream words(line);
            double             version = 0.;
            if (section == "MeshFormat" && words >> version)
              is_old = version < 4.;
            else if (is_count && !(words >> announced))
              fail("line " + std::to_string(number) + " is '" + line +
                   "'; expected the number of entries of '$" + section + "'");
          }
        else if (is_old && section == "Elements")
          {
            // number, type, number of tags, tags, nodes
            std::istringstream words(line);
            long entry = 0, type = 0, n_tags = -1, word = 0, n_words = 0;
            words >> entry >> type >> n_tags;
            while (words >> word)
              ++n_words;
            if (n_tags < 0 || n_tags >= n_words)
              fail("line " + std::to_string(number) + " is '" + line +
                   "'; expected number, type, number of tags, tags and "
                   "nodes of an element");
          }
      }
    if (!section.empty())
      fail("'$" + section + "' in line " + std::to_string(first) +
           " has no '$End" + section + "'");
  }
} // namespace Structure
