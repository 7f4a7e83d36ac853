#pragma once
// What became of the cases of a batch: as a table, as JSON and as a page.

#include <optional>
#include <string>
#include <vector>

namespace handlebody::cli {

enum class CaseStatus { done, failed, refused, notRun };
//! done, failed, refused, not run
const char* statusName(CaseStatus status);

//! Of a case that was carried through the frames of a 4D volume.
struct TimeMeasures {
  int frames = 0, failed = 0;
  //! mm³, and 0 to 1; none if fewer than two frames can be trusted.
  std::optional<double> endDiastole{}, endSystole{}, strokeVolume{}, ejectionFraction{};
};

//! The numbers of a result.
struct CaseMeasures {
  double volume = 0;                    //!< mm³
  double area = 0;                      //!< mm²
  double largestDiameter = 0;           //!< mm
  std::vector<double> extents;          //!< along the principal axes, mm, the longest first
  std::optional<double> meanIntensity;  //!< none if no voxel lies inside
  int components = 0;
  std::vector<int> genus;  //!< per component
  int vertices = 0, faces = 0, iterations = 0;
  std::string stopped;                         //!< why
  std::optional<double> unsupportedSurface{};  //!< part of the surface, 0 to 1; none if not compared
  double seconds = 0;                          //!< by the clock
  double peakMegabytes = 0;
  std::vector<std::string> warnings;  //!< of the volume and of the result
  std::optional<TimeMeasures> overTime{};
};

struct SummaryRow {
  int line = 0;  //!< of the study
  std::string name, volume;
  CaseStatus status = CaseStatus::notRun;
  std::string message;                   //!< why there is no result
  std::optional<CaseMeasures> measures;  //!< of one that is done
  std::string folder;                    //!< of its results, relative to the summary
  std::vector<std::string> files;        //!< results in it
  std::string log;                       //!< of a failure, relative to the summary; empty: none
  std::string thumbnail;                 //!< bytes of a PNG; empty: none
};

struct Summary {
  std::string study;  //!< name of its file
  std::string version;
  std::vector<SummaryRow> rows;
  int count(CaseStatus status) const;
};

//! RFC 4180, in UTF-8. Numbers with the fewest digits that read back to the same; genus and warnings in one
//! cell each, separated by semicolons.
std::string summaryCsv(const Summary& summary);
std::string summaryJson(const Summary& summary);
//! One HTML page that needs nothing but itself; the links to results are relative to it.
std::string summaryPage(const Summary& summary);

//! Reads the measures of a folder that finish() made. Throws InputError.
CaseMeasures readMeasures(const std::string& folder);

}  // namespace handlebody::cli
