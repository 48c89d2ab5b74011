// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shell_file.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

namespace Structure
{
  namespace
  {
    std::string
    upper(std::string text)
    {
      std::transform(text.begin(), text.end(), text.begin(), [](const char c) {
        return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      });
      return text;
    }

    /// Nodes of a shell element by its type; 0: it is none.
    unsigned int
    n_nodes_of(const std::string &type)
    {
      if (type == "STRI3" || type == "R3D3" || type.rfind("S3", 0) == 0)
        return 3;
      if (type == "R3D4" || type.rfind("S4", 0) == 0)
        return 4;
      return 0;
    }

    /// The keyword that the lines being read belong to.
    struct Keyword
    {
      std::string                        name;
      std::map<std::string, std::string> options;
    };

    /// What is in the file, by Abaqus' numbers.
    struct Deck
    {
      std::map<unsigned long, Point<3>>                   nodes;
      std::map<unsigned long, std::vector<unsigned long>> elements;
      std::map<std::string, std::set<unsigned long>>      sets;
      std::vector<std::string>      of_elements, of_sections;
      std::map<std::string, double> thickness;
    };

    class Reader
    {
    public:
      explicit Reader(const std::string &file)
        : file(file)
        , in(file)
      {
        AssertThrow(in,
                    ExcMessage("'Mesh/File' is '" + file +
                               "'; this file cannot be opened."));
      }

      Deck
      read()
      {
        std::string line;
        while (std::getline(in, line))
          {
            ++number;
            line = Utilities::trim(line);
            if (line.empty() || line.rfind("**", 0) == 0)
              continue;
            // a line that ends with a comma goes on
            std::string more;
            while (line[0] == '*' && line.back() == ',' &&
                   std::getline(in, more))
              {
                ++number;
                line += Utilities::trim(more);
              }
            if (line[0] == '*')
              start(line);
            else
              data(Utilities::split_string_list(line));
          }
        return deck;
      }

      [[noreturn]] void
      fail(const std::string &found, const std::string &expected) const
      {
        throw ExcMessage("'Mesh/File' is '" + file + "': line " +
                         std::to_string(number) + " has '" + found +
                         "'; expected " + expected + ".");
      }

    private:
      void
      start(const std::string &line)
      {
        const std::vector<std::string> words =
          Utilities::split_string_list(line.substr(1));
        keyword      = Keyword();
        keyword.name = upper(words[0]);
        for (std::size_t i = 1; i < words.size(); ++i)
          {
            const std::size_t equals = words[i].find('=');
            keyword
              .options[upper(Utilities::trim(words[i].substr(0, equals)))] =
              equals == std::string::npos ?
                "" :
                upper(Utilities::trim(words[i].substr(equals + 1)));
          }
        n_data = 0;
        if (keyword.name == "INSTANCE")
          fail(line, "a file without instances (flat input)");
        if (keyword.name == "ELEMENT")
          {
            n_nodes = n_nodes_of(keyword.options["TYPE"]);
            if (n_nodes == 0)
              fail("TYPE=" + keyword.options["TYPE"],
                   "shells with 3 or 4 nodes: S3, S4, R3D3, R3D4 and the like");
            remember(deck.of_elements, keyword.options["ELSET"]);
          }
        for (const char *option : {"COMPOSITE", "OFFSET", "NODAL THICKNESS"})
          if (keyword.name == "SHELL SECTION" &&
              keyword.options.count(option) > 0)
            fail(option, "a section of one thickness without offset");
        if (keyword.name == "SHELL SECTION")
          remember(deck.of_sections, keyword.options["ELSET"]);
      }

      static void
      remember(std::vector<std::string> &list, const std::string &name)
      {
        if (std::find(list.begin(), list.end(), name) == list.end())
          list.push_back(name);
      }

      double
      real(const std::string &word) const
      {
        if (!Patterns::Double().match(word))
          fail(word, "a number");
        return Utilities::string_to_double(word);
      }

      unsigned long
      whole(const std::string &word) const
      {
        if (!Patterns::Integer(0).match(word))
          fail(word, "a whole number");
        return std::stoul(word);
      }

      void
      data(const std::vector<std::string> &words)
      {
        ++n_data;
        if (keyword.name == "NODE")
          {
            if (words.size() < 4)
              fail(words[0], "a number of a node and three coordinates");
            const Point<3> x(real(words[1]), real(words[2]), real(words[3]));
            if (!deck.nodes.emplace(whole(words[0]), x).second)
              fail(words[0], "a number that no other node has");
          }
        else if (keyword.name == "ELEMENT")
          {
            if (words.size() < n_nodes + 1)
              fail(words[0],
                   "a number of an element and " + std::to_string(n_nodes) +
                     " nodes");
            std::vector<unsigned long> nodes;
            for (unsigned int v = 0; v < n_nodes; ++v)
              nodes.push_back(whole(words[1 + v]));
            const unsigned long element = whole(words[0]);
            if (!deck.elements.emplace(element, nodes).second)
              fail(words[0], "a number that no other element has");
            deck.sets[keyword.options["ELSET"]].insert(element);
          }
        else if (keyword.name == "ELSET")
          {
            auto &set = deck.sets[keyword.options["ELSET"]];
            if (keyword.options.count("GENERATE") > 0)
              {
                if (words.size() < 2)
                  fail(words[0], "first, last, increment");
                const unsigned long last = whole(words[1]);
                const unsigned long step =
                  words.size() > 2 ? std::max(1ul, whole(words[2])) : 1;
                for (unsigned long e = whole(words[0]); e <= last; e += step)
                  set.insert(e);
              }
            else
              for (const std::string &word : words)
                if (Patterns::Integer(0).match(word))
                  set.insert(std::stoul(word));
                else if (!word.empty())
                  {
                    const auto other = deck.sets.find(upper(word));
                    if (other == deck.sets.end())
                      fail(word, "a number or a set that is already there");
                    set.insert(other->second.begin(), other->second.end());
                  }
          }
        else if (keyword.name == "SHELL SECTION" && n_data == 1)
          {
            const double t = real(words[0]);
            if (!(t > 0.))
              fail(words[0], "a positive thickness");
            deck.thickness[keyword.options["ELSET"]] = t;
          }
      }

      const std::string file;
      std::ifstream     in;
      unsigned int      number = 0, n_data = 0, n_nodes = 0;
      Keyword           keyword;
      Deck              deck;
    };
  } // namespace


  ShellParts
  read_abaqus_shell(const std::string &file, Triangulation<2, 3> &mesh)
  {
    Reader            reader(file);
    const Deck        deck = reader.read();
    const std::string is   = "'Mesh/File' is '" + file + "': ";
    AssertThrow(!deck.elements.empty(),
                ExcMessage(is + "it has no *ELEMENT of shells."));

    // Step 1: the part of each element.
    ShellParts                                  parts;
    std::map<unsigned long, types::material_id> part_of;
    const bool has_sections = !deck.of_sections.empty();
    for (const std::string &name :
         has_sections ? deck.of_sections : deck.of_elements)
      {
        const auto set = deck.sets.find(name);
        AssertThrow(set != deck.sets.end(),
                    ExcMessage(is + "*SHELL SECTION names the set '" + name +
                               "', which is not there."));
        const types::material_id id = parts.names.size() + 1;
        parts.names[name]           = id;
        for (const unsigned long e : set->second)
          AssertThrow(part_of.emplace(e, id).second,
                      ExcMessage(is + "element " + std::to_string(e) +
                                 " belongs to two parts, '" + name +
                                 "' and another."));
        const auto thickness = deck.thickness.find(name);
        if (thickness != deck.thickness.end())
          parts.thickness[id] = thickness->second;
      }

    // Step 2: the mesh.
    std::map<unsigned long, unsigned int> vertex_of;
    std::vector<Point<3>>                 vertices;
    for (const auto &[node, x] : deck.nodes)
      {
        vertex_of[node] = vertices.size();
        vertices.push_back(x);
      }
    std::vector<CellData<2>> cells;
    for (const auto &[element, nodes] : deck.elements)
      {
        // Abaqus allows triangles as quadrilaterals with two equal nodes
        std::vector<unsigned long> distinct;
        for (const unsigned long n : nodes)
          if (std::find(distinct.begin(), distinct.end(), n) == distinct.end())
            distinct.push_back(n);
        CellData<2> cell(distinct.size());
        for (std::size_t v = 0; v < distinct.size(); ++v)
          {
            const auto vertex = vertex_of.find(distinct[v]);
            AssertThrow(vertex != vertex_of.end(),
                        ExcMessage(is + "element " + std::to_string(element) +
                                   " has the node " +
                                   std::to_string(distinct[v]) +
                                   ", which is not there."));
            cell.vertices[v] = vertex->second;
          }
        AssertThrow(distinct.size() >= 3,
                    ExcMessage(is + "element " + std::to_string(element) +
                               " has fewer than 3 different nodes."));
        if (distinct.size() == 4)
          std::swap(cell.vertices[2], cell.vertices[3]);
        const auto part = part_of.find(element);
        AssertThrow(part != part_of.end(),
                    ExcMessage(is + "element " + std::to_string(element) +
                               " belongs to no *SHELL SECTION."));
        cell.material_id = part->second;
        cells.push_back(cell);
      }
    SubCellData none;
    GridTools::delete_unused_vertices(vertices, cells, none);
    // quadrilaterals first: edges of triangles have no direction
    const auto first_triangle =
      std::stable_partition(cells.begin(), cells.end(), [](const auto &c) {
        return c.vertices.size() == 4;
      });
    std::vector<CellData<2>> quadrilaterals(cells.begin(), first_triangle);
    if (!quadrilaterals.empty())
      GridTools::consistently_order_cells(quadrilaterals);
    std::copy(quadrilaterals.begin(), quadrilaterals.end(), cells.begin());
    mesh.create_triangulation(vertices, cells, none);
    return parts;
  }


  ShellParts
  gmsh_parts(const std::string &file)
  {
    ShellParts    parts;
    std::ifstream in(file);
    std::string   line;
    while (std::getline(in, line) && Utilities::trim(line) != "$PhysicalNames")
      ;
    unsigned int n = 0;
    in >> n;
    for (unsigned int i = 0; i < n && std::getline(in >> std::ws, line); ++i)
      {
        std::istringstream words(line);
        unsigned int       dimension = 0, id = 0;
        std::string        name;
        words >> dimension >> id;
        std::getline(words >> std::ws, name);
        if (dimension == 2 && name.size() > 2)
          parts.names[name.substr(1, name.rfind('"') - 1)] = id;
      }
    return parts;
  }
} // namespace Structure
