// SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_deck.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <fstream>

namespace Structure
{
  namespace
  {
    // What is generated is kept: more would fill the memory.
    constexpr unsigned long most_generated = 100000000;

    std::string
    upper(std::string text)
    {
      std::transform(text.begin(), text.end(), text.begin(), [](const char c) {
        return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      });
      return text;
    }

    /// Nodes of an element by its type; 0: it is none of the kind.
    unsigned int
    n_nodes_of(const std::string &type, const AbaqusKind kind)
    {
      const auto is = [&](const char *family) {
        const std::string f = family;
        // letters for reduced integration and the like may follow, no digits
        return type.rfind(f, 0) == 0 &&
               (type.size() == f.size() ||
                std::isdigit(static_cast<unsigned char>(type[f.size()])) == 0);
      };
      switch (kind)
        {
          case AbaqusKind::shell:
            return (is("S3") || is("STRI3") || is("R3D3")) ? 3 :
                   (is("S4") || is("R3D4"))                ? 4 :
                                                             0;
          case AbaqusKind::plane:
            return (is("CPE3") || is("CPS3")) ? 3 :
                   (is("CPE4") || is("CPS4")) ? 4 :
                                                0;
          case AbaqusKind::solid:
            return is("C3D4") ? 4 : is("C3D8") ? 8 : 0;
        }
      return 0;
    }

    std::string
    expected_types(const AbaqusKind kind)
    {
      switch (kind)
        {
          case AbaqusKind::shell:
            return "shells with 3 or 4 nodes: S3, S4, R3D3, R3D4 and the like";
          case AbaqusKind::plane:
            return "plane elements with 3 or 4 nodes: CPE3, CPE4, CPS3, CPS4 "
                   "and the like";
          case AbaqusKind::solid:
            return "solids with 4 or 8 nodes: C3D4, C3D8 and the like, a file "
                   "for each body";
        }
      return "";
    }

    /// The keyword that the lines being read belong to.
    struct Keyword
    {
      std::string                        name;
      std::map<std::string, std::string> options;
    };

    class Reader
    {
    public:
      Reader(const std::string &file, const AbaqusKind kind)
        : file(file)
        , kind(kind)
        , in(file)
      {
        AssertThrow(in,
                    ExcMessage("'Mesh/File' is '" + file +
                               "'; this file cannot be opened."));
      }

      AbaqusDeck
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
        find_parts();
        return std::move(deck);
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
        if (words.empty())
          fail(line, "a keyword");
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
            n_nodes = n_nodes_of(keyword.options["TYPE"], kind);
            if (n_nodes == 0)
              fail("TYPE=" + keyword.options["TYPE"], expected_types(kind));
            remember(deck.of_elements, keyword.options["ELSET"]);
          }
        for (const char *option : {"COMPOSITE", "OFFSET", "NODAL THICKNESS"})
          if (keyword.name == "SHELL SECTION" &&
              keyword.options.count(option) > 0)
            fail(option, "a section of one thickness without offset");
        if (keyword.name == "SHELL SECTION" || keyword.name == "SOLID SECTION")
          remember(deck.of_sections, keyword.options["ELSET"]);
        // the edges and sides of shells are skins already
        is_surface = keyword.name == "SURFACE" && kind != AbaqusKind::shell &&
                     (keyword.options.count("TYPE") == 0 ||
                      keyword.options["TYPE"] == "ELEMENT");
        if (is_surface)
          deck.surfaces.push_back({keyword.options["NAME"], {}});
      }

      /// The elements of a number or of a set.
      std::set<unsigned long>
      elements_of(const std::string &word) const
      {
        if (Patterns::Integer(0).match(word))
          return {whole(word)};
        const auto set = deck.sets.find(upper(word));
        if (set == deck.sets.end())
          fail(word, "a number or a set that is already there");
        return set->second;
      }

      void
      surface_line(const std::vector<std::string> &words)
      {
        const std::string face = words.size() > 1 ? upper(words[1]) : "";
        if (face.size() != 2 || face[0] != 'S' || face[1] < '1' ||
            face[1] > '6')
          fail(words.size() > 1 ? words[1] : words[0],
               "an element or a set, and its face S1 to S6");
        for (const unsigned long e : elements_of(words[0]))
          deck.surfaces.back().second.emplace_back(e, face[1] - '0');
      }

      void
      find_parts()
      {
        const std::string is = "'Mesh/File' is '" + file + "': ";
        AssertThrow(!deck.elements.empty(),
                    ExcMessage(is + "it has no *ELEMENT; expected " +
                               expected_types(kind) + "."));
        const bool has_sections = !deck.of_sections.empty();
        for (const std::string &name :
             has_sections ? deck.of_sections : deck.of_elements)
          {
            const auto set = deck.sets.find(name);
            AssertThrow(set != deck.sets.end(),
                        ExcMessage(is + "a section names the set '" + name +
                                   "', which is not there."));
            const types::material_id id = deck.part_ids.size() + 1;
            deck.part_ids[name]         = id;
            for (const unsigned long e : set->second)
              AssertThrow(deck.part_of.emplace(e, id).second,
                          ExcMessage(is + "element " + std::to_string(e) +
                                     " belongs to two parts, '" + name +
                                     "' and another."));
          }
        for (const auto &element : deck.elements)
          {
            AssertThrow(deck.part_of.count(element.first) > 0,
                        ExcMessage(is + "element " +
                                   std::to_string(element.first) +
                                   " belongs to no section."));
            for (const unsigned long n : element.second)
              AssertThrow(deck.nodes.count(n) > 0,
                          ExcMessage(is + "element " +
                                     std::to_string(element.first) +
                                     " has the node " + std::to_string(n) +
                                     ", which is not there."));
          }
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
            const bool is_plane = kind == AbaqusKind::plane;
            if (words.size() < (is_plane ? 3 : 4))
              fail(words[0],
                   is_plane ? "a number of a node and two coordinates" :
                              "a number of a node and three coordinates");
            const Point<3> x(real(words[1]),
                             real(words[2]),
                             is_plane ? 0. : real(words[3]));
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
                const unsigned long first = whole(words[0]);
                if (last >= first && (last - first) / step > most_generated)
                  fail(words[0] + ", " + words[1],
                       "at most " + std::to_string(most_generated) +
                         " elements of a set");
                for (unsigned long e = first; e <= last; e += step)
                  set.insert(e);
              }
            else
              for (const std::string &word : words)
                if (!word.empty())
                  {
                    const std::set<unsigned long> more = elements_of(word);
                    set.insert(more.begin(), more.end());
                  }
          }
        else if (is_surface)
          surface_line(words);
        else if (keyword.name == "SHELL SECTION" && n_data == 1)
          {
            const double t = real(words[0]);
            if (!(t > 0.))
              fail(words[0], "a positive thickness");
            deck.thickness[keyword.options["ELSET"]] = t;
          }
      }

      const std::string file;
      const AbaqusKind  kind;
      std::ifstream     in;
      unsigned int      number = 0, n_data = 0, n_nodes = 0;
      bool              is_surface = false;
      Keyword           keyword;
      AbaqusDeck        deck;
    };
  } // namespace


  AbaqusDeck
  read_abaqus(const std::string &file, const AbaqusKind kind)
  {
    return Reader(file, kind).read();
  }
} // namespace Structure
