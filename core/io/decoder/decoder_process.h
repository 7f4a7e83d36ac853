#pragma once
// Internal: the child process that decodes DICOM and VTP, as its parent sees it. GDCM's build in Debian
// aborts on some malformed files, VTK's XML reader crashes or hangs; here that and an excessive memory use
// are sentences.

#include "core/io/decoder/decoder_channel.h"

namespace handlebody {

class DecoderProcess {
 public:
  //! Starts it. Throws InputError (which begins with `path`) if the program is not there.
  DecoderProcess(std::string path, const DecoderSettings& settings);
  //! Kills it if it still runs.
  ~DecoderProcess();
  DecoderProcess(const DecoderProcess&) = delete;
  DecoderProcess& operator=(const DecoderProcess&) = delete;

  void send(const Message& message);
  //! The next message but for progress, which is passed on as from + part · (to − from). Throws
  //! InputError for what the child refuses and for its death or silence, UsageError, Cancelled.
  Message receive(const ReadProgress& progress, double from, double to);
  //! The child may have so many bytes of address space more than when it was ready.
  void allowMemory(std::uint64_t bytes);
  //! What the child has filled, once it has ended; nobody else has it. Throws InputError if that is less than
  //! `bytes`.
  std::shared_ptr<void> takeMemory(std::uint64_t bytes);

 private:
  struct NotStarted {};
  DecoderProcess(std::string path, double patience, NotStarted)
      : path_(std::move(path)), patience_(patience) {}
  void start(const std::string& program);
  void waitForMessage();
  void noteProgress(const Message& message, const ReadProgress& progress, double from, double to);
  [[noreturn]] void explainDeath();
  [[noreturn]] void refuseHang();
  void kill();
  //! That something went wrong with the whole, or with the file that came next.
  [[noreturn]] void refuseOn(FindingKind whole, FindingKind part, Finding::Values values = {}) const;
  std::string path_;
  double patience_;          // DecoderSettings::patience
  std::string file_;         // which the child works on
  std::uint64_t bytes_ = 0;  // of it
  int child_ = -1, socket_ = -1, memory_ = -1;
  std::uint64_t base_ = 0;  // address space of the child at rest
};

}  // namespace handlebody
