// SPDX-License-Identifier: LGPL-2.1-or-later
#include "scene_source.h"

#include "accuracy.h"
#include "suggestion.h"

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace Structure
{
  std::string
  used_entries(const ParameterHandler &prm, const SceneSource &source)
  {
    std::ostringstream out;
    prm.print_parameters(out,
                         source.only_changed ? ParameterHandler::PRM :
                                               ParameterHandler::ShortPRM);
    if (!source.only_changed)
      return out.str();
    // the annotated form says where a value is not the default; what a file has
    // taken back from 'Accuracy' counts, too
    const std::string        mark     = "# default:";
    const bool               has_many = prm.get("Accuracy") != "balanced";
    std::istringstream       in(out.str());
    std::string              line;
    std::vector<std::string> kept;
    while (std::getline(in, line))
      {
        const std::string text = Utilities::trim(line);
        if (text.rfind("subsection ", 0) == 0)
          kept.push_back(line);
        else if (text.rfind("set ", 0) == 0)
          {
            const std::string entry =
              Utilities::trim(text.substr(4, text.find('=') - 4));
            if (line.find(mark) != std::string::npos || entry == "Driver" ||
                (has_many && is_set_by_accuracy(entry)))
              kept.push_back(line.substr(0, line.find(mark)));
          }
        else if (text == "end")
          {
            // a section without entries is none
            if (Utilities::trim(kept.back()).rfind("subsection ", 0) == 0)
              kept.pop_back();
            else
              kept.push_back(line);
          }
      }
    std::string result;
    for (const std::string &k : kept)
      result += k.substr(0, k.find_last_not_of(' ') + 1) + "\n";
    return result;
  }


  namespace
  {
    /// Sections and entries of a JSON object, in the form of a parameter file.
    std::string
    text_of(const nlohmann::json &object, const std::string &where)
    {
      std::string text;
      for (const auto &item : object.items())
        {
          const std::string     name  = item.key();
          const nlohmann::json &value = item.value();
          if (value.is_object())
            {
              text += "subsection " + name + "\n" +
                      text_of(value, where + name + "/") + "end\n";
              continue;
            }
          std::string written;
          const auto  add = [&](const nlohmann::json &one) {
            AssertThrow(one.is_string() || one.is_number() || one.is_boolean(),
                        ExcMessage("'" + where + name + "' is '" +
                                   value.dump() +
                                   "'; expected a string, a number, true or "
                                    "false, or a list of them."));
            written += (written.empty() ? "" : ", ") +
                       (one.is_string() ? one.get<std::string>() : one.dump());
          };
          if (value.is_array())
            for (const nlohmann::json &one : value)
              add(one);
          else
            add(value);
          text += "set " + name + " = " + written + "\n";
        }
      return text;
    }

    /// A file in JSON: sections are objects, values strings, numbers, booleans
    /// or lists of them.
    std::string
    text_of_json(std::istream &in, const std::string &file)
    {
      nlohmann::json json;
      std::string    error;
      try
        {
          json = nlohmann::json::parse(in);
        }
      catch (const nlohmann::json::exception &e)
        {
          error = e.what();
        }
      AssertThrow(error.empty() && json.is_object(),
                  ExcMessage("The parameter file '" + file +
                             "' is no JSON object: " + error));
      return text_of(json, "");
    }
  } // namespace


  void
  parse(ParameterHandler  &prm,
        const SceneSource &source,
        const bool         skip_undefined)
  {
    std::ifstream in(source.file);
    AssertThrow(!std::filesystem::is_directory(source.file),
                ExcMessage("The parameter file '" + source.file +
                           "' is a folder; expected a file."));
    AssertThrow(in,
                ExcMessage("The parameter file '" + source.file +
                           "' cannot be opened."));
    const auto read_text = [&](std::istream &text, const std::string &name) {
      try
        {
          prm.parse_input(text, name, "", skip_undefined);
        }
      catch (const ExceptionBase &e)
        {
          std::ostringstream info;
          e.print_info(info);
          const std::string error = Utilities::trim(info.str());
          AssertThrow(false, ExcMessage(error + did_you_mean(prm, error)));
        }
    };
    const std::string json = ".json";
    const bool        is_json =
      source.file.size() > json.size() &&
      source.file.substr(source.file.size() - json.size()) == json;
    if (is_json)
      {
        std::istringstream text(text_of_json(in, source.file));
        read_text(text, source.file);
      }
    else
      read_text(in, source.file);
    for (const std::string &setting : source.settings)
      {
        const std::size_t equals = setting.find('=');
        AssertThrow(equals != std::string::npos,
                    ExcMessage("--set '" + setting +
                               "': expected \"Section/Entry=value\"."));
        std::vector<std::string> path =
          Utilities::split_string_list(setting.substr(0, equals), '/');
        std::string text, ends;
        for (std::size_t i = 0; i + 1 < path.size(); ++i)
          {
            text += "subsection " + path[i] + "\n";
            ends += "end\n";
          }
        text +=
          "set " + path.back() + " = " + setting.substr(equals + 1) + "\n";
        std::istringstream line(text + ends);
        read_text(line, "--set \"" + setting + "\"");
      }
    if (skip_undefined)
      AssertThrow(prm.get("Driver") == source.driver,
                  ExcMessage("'Driver' in '" + source.file + "' is '" +
                             prm.get("Driver") + "'; this is '" +
                             source.driver + "'."));
  }
} // namespace Structure
