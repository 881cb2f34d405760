#pragma once

#include <QString>

#include <vector>

namespace luxdeck::gui {

/// A project that comes with the program.
struct SampleProject {
    QString name;         ///< as its project.toml says
    QString description;  ///< its first sentence
    QString file;         ///< project.toml
    QString picture;      ///< beside it; empty: none
};

/// Those in $LUXDECK_PROJECTS, or beside the program: installed in share/luxdeck/projects, or in the source tree it was built from.
std::vector<SampleProject> sampleProjects();

}  // namespace luxdeck::gui
