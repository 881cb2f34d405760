#pragma once

#include "engine/core/result.h"

#include <QHash>
#include <QString>

#include <string>

namespace luxdeck::report {

/// Qt needs an application for fonts; the command line has none, the desktop program has its own.
void ensureApplication();

/// The family that drawings use; errors when no font is installed at all. After ensureApplication().
Result<QString> requireFont();

/// Qt writes a PDF's fonts in the order of a hash table, which is random from process to process unless its
/// seed is fixed. Tables that exist keep the seed they were made with, so this disturbs nobody.
class FixedHashOrder {
public:
    FixedHashOrder() { qSetGlobalQHashSeed(0); }
    ~FixedHashOrder() { qSetGlobalQHashSeed(before_ == 0 ? 0 : -1); }
    FixedHashOrder(const FixedHashOrder&) = delete;
    FixedHashOrder& operator=(const FixedHashOrder&) = delete;

private:
    int before_ = qGlobalQHashSeed();
};

/// Qt writes the time of writing: puts `created` ("2026-11-22T18:40:00Z"; empty: a fixed day) in its place, at the
/// same length, so that the table of offsets at the end of the file stays right.
void fixPdfDate(std::string& pdf, const std::string& created);

}  // namespace luxdeck::report
