// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/output/files/archive.h>
#include <fuga/output/files/version.h>
#include <fuga/output/restart/checkpoint.h>

#include <filesystem>
#include <fmt/format.h>

namespace fuga
{
  namespace
  {
    /** Format number, to be increased with every change in the meaning of stored numbers that no
     * name of a field shows. */
    constexpr int format = 4;

    using archive::Json;

    std::string_view
    view(const std::vector<std::uint8_t> &bytes)
    {
      return {reinterpret_cast<const char *>(bytes.data()), bytes.size()};
    }

    [[noreturn]] void
    refuse(const std::string &path, const std::string &reason)
    {
      throw InputError(fmt::format(
        "The checkpoint {} {}. Run without --restart to compute everything from the beginning.",
        path,
        reason));
    }

    Json
    read_content(const std::string &path)
    {
      const std::string text = read_file(path);
      const Json file        = Json::from_cbor(text);
      if (file.at("format") != format || file.at("version") != version)
        refuse(path,
               fmt::format("was written by another version of the program ({})",
                           file.at("version").get<std::string>()));
      const auto &content = file.at("content").get_ref<const Json::binary_t &>();
      if (checksum(view(content)) != file.at("checksum").get<std::uint32_t>())
        refuse(path, "is damaged");
      return Json::from_cbor(content);
    }

    void
    check_results(const std::string &directory, const Checkpoint &checkpoint)
    {
      for (const auto &[name, memory] : checkpoint.tables.files)
        recover_text(directory + "/" + name, memory);
      recover_text(directory + "/log.txt", checkpoint.log.text);
      for_each_field(checkpoint.fields, [&](const char *, const auto &collection) {
        for (const auto &[t, file] : collection)
          if (!std::filesystem::exists(directory + "/" + file))
            throw InputError(fmt::format("The result {}/{} is gone.", directory, file));
      });
    }
  } // namespace

  void
  write_checkpoint(const std::string &directory, const Checkpoint &checkpoint)
  {
    Json::binary_t content(Json::to_cbor(archive::encode(checkpoint)));
    Json file        = {{"program", "fuga"}, {"version", version}, {"format", format}};
    file["checksum"] = checksum(view(content));
    file["content"]  = std::move(content);
    std::string text;
    Json::to_cbor(file, text);
    write_complete_file(directory + "/" + checkpoint_file_name, text);
  }

  Checkpoint
  read_checkpoint(const std::string &directory)
  {
    const std::string path = directory + "/" + checkpoint_file_name;
    if (!std::filesystem::exists(path))
      throw InputError(fmt::format(
        "There is no checkpoint {}: nothing can be restarted. Run without --restart, or name the "
        "directory of the run by --output-dir. (Checkpoints are written unless 'Output/Checkpoint' "
        "says never.)",
        path));
    Checkpoint checkpoint;
    try
      {
        archive::decode(read_content(path), checkpoint);
      }
    catch (const InputError &)
      {
        throw;
      }
    catch (const std::exception &)
      {
        refuse(path, "is damaged or was written by another version of the program");
      }
    try
      {
        check_results(directory, checkpoint);
      }
    catch (const InputError &error)
      {
        refuse(path, fmt::format("does not fit the results beside it: {}", error.what()));
      }
    return checkpoint;
  }
} // namespace fuga
