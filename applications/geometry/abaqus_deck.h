// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_abaqus_deck_h
#define mortar_contact_applications_abaqus_deck_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /// Kinds of elements; a file has one of them.
  enum class AbaqusKind
  {
    shell, ///< S3, S4 and their kin, STRI3, R3D3, R3D4
    plane, ///< CPE3, CPE4, CPS3, CPS4 and their kin
    solid  ///< C3D4, C3D8 and their kin
  };

  /// What an Abaqus input file without *INSTANCE says of a mesh, by its own
  /// numbers. Names are in capitals.
  struct AbaqusDeck
  {
    std::map<unsigned long, Point<3>>                   nodes;
    std::map<unsigned long, std::vector<unsigned long>> elements;
    std::map<std::string, std::set<unsigned long>>      sets;
    /// Sets of *ELEMENT and of sections, in the order of the file.
    std::vector<std::string>      of_elements, of_sections;
    std::map<std::string, double> thickness; ///< Of *SHELL SECTION [m]
    /// *SURFACE of faces: element, number of the face from 1.
    std::vector<std::pair<std::string,
                          std::vector<std::pair<unsigned long, unsigned int>>>>
      surfaces;

    /// Parts, with ids 1, 2, ...: the sets of sections in the order of the
    /// file, without sections those of *ELEMENT.
    std::map<std::string, types::material_id> part_ids;
    /// Of each element.
    std::map<unsigned long, types::material_id> part_of;
  };

  /// @throw ExcMessage naming the file and the line.
  AbaqusDeck
  read_abaqus(const std::string &file, const AbaqusKind kind);
} // namespace Structure

#endif
