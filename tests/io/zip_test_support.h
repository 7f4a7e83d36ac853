#pragma once
// ZIP archives for tests, straight by libzip: nothing of ours has a part in them.

#include <zip.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace handlebody::test {

struct Packed {
  std::string name, content;
  int method = ZIP_CM_DEFLATE;
  bool isEncrypted = false;
};

//! Throws std::runtime_error if libzip does not.
inline std::string archiveOf(const std::vector<Packed>& entries) {
  const auto require = [](bool done) {
    if (!done) throw std::runtime_error("libzip made no archive");
  };
  zip_source_t* source = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  require(source != nullptr);
  zip_source_keep(source);
  zip_t* archive = zip_open_from_source(source, ZIP_TRUNCATE, nullptr);
  require(archive != nullptr);
  for (const Packed& e : entries) {
    zip_source_t* content = zip_source_buffer(archive, e.content.data(), e.content.size(), 0);
    const zip_int64_t at = zip_file_add(archive, e.name.c_str(), content, ZIP_FL_ENC_UTF_8);
    require(at >= 0);
    const auto index = static_cast<zip_uint64_t>(at);
    require(zip_set_file_compression(archive, index, e.method, 0) == 0);
    if (e.isEncrypted) require(zip_file_set_encryption(archive, index, ZIP_EM_AES_256, "secret") == 0);
  }
  require(zip_close(archive) == 0);
  zip_stat_t is;
  zip_stat_init(&is);
  require(zip_source_open(source) == 0 && zip_source_stat(source, &is) == 0);
  std::string bytes(static_cast<std::size_t>(is.size), '\0');
  require(zip_source_read(source, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size()));
  zip_source_close(source);
  zip_source_free(source);
  return bytes;
}

//! A 3MF file of this model, stored.
inline std::string archiveOfModel(const std::string& xml) {
  return archiveOf(
      {{"_rels/.rels",
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/m.model\" Id=\"r\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>",
        ZIP_CM_STORE},
       {"3D/m.model", xml, ZIP_CM_STORE}});
}

}  // namespace handlebody::test
