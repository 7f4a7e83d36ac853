#pragma once
// Option values from text. Independent of the locale; every error is a UsageError that names the option.

#include <array>
#include <string>
#include <vector>

#include "core/evolution/parameters.h"

namespace handlebody {

//! A number; "inf" and "-inf" count, NaN does not.
double parseNumber(const std::string& option, const std::string& text);
//! A whole number in [lowest, highest].
int parseInteger(const std::string& option, const std::string& text, int lowest, int highest);
//! The number of a label, in [lowest, highest], or else its name, as it is.
std::string parseLabel(const std::string& option, const std::string& text, int lowest, int highest);
//! Numbers with commas between them.
std::vector<double> parseNumbers(const std::string& option, const std::string& text);
//! X,Y,Z, all finite.
Vec3 parseVector(const std::string& option, const std::string& text);
//! Whole numbers >= lowest with commas between them.
std::vector<int> parseIntegers(const std::string& option, const std::string& text, int lowest);
//! LO,HI with LO <= HI.
IntensityRange parseRange(const std::string& option, const std::string& text);
//! X,Y,Z,R in mm; R > 0.
WallBall parseWall(const std::string& option, const std::string& text);
//! X,Y,Z,NX,NY,NZ,R in mm; a normal of some length, R > 0.
WallDisc parseWallDisc(const std::string& option, const std::string& text);
//! ITERATION:X,Y,Z, the iteration at least 1.
Pin parsePin(const std::string& option, const std::string& text);
Veto parseVeto(const std::string& option, const std::string& text);
//! ITERATION:KIND:X,Y,Z, the kind close-tunnel, fill-tunnel, cut-handle, remove-component, keep-component or
//! fill-cavity.
//! "X,Y,Z,R".
MeshEdit parseSmoothing(const std::string& option, const std::string& text);
//! "X,Y,Z,X2,Y2,Z2,R".
MeshEdit parsePull(const std::string& option, const std::string& text);
//! "X,Y,Z,NX,NY,NZ[,R][,both|positive|negative]".
MeshEdit parsePlaneCut(const std::string& option, const std::string& text);
MeshEdit parseMeshEdit(const std::string& option, const std::string& text);
//! X,Y,Z[,R] in any one unit; R > 0.
Seed parseSeed(const std::string& option, const std::string& text);

}  // namespace handlebody
