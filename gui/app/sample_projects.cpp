#include "gui/app/sample_projects.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace luxdeck::gui {

namespace {

/// Those worth a picture, the first one for beginners; what each shows.
struct Known {
    const char *folder, *name, *description;
};
const Known kKnown[] = {
    {"office", QT_TRANSLATE_NOOP("Samples", "Open office"), QT_TRANSLATE_NOOP("Samples", "Sixteen workplaces, a glazed meeting room, 37 luminaires, twelve calculation surfaces")},
    {"classroom", QT_TRANSLATE_NOOP("Samples", "Classroom"), QT_TRANSLATE_NOOP("Samples", "Daylight from the side and lamps, under an overcast sky")},
    {"gallery", QT_TRANSLATE_NOOP("Samples", "Gallery"), QT_TRANSLATE_NOOP("Samples", "Spots on pictures, a mirror and glass")},
};

QString folderOfSamples() {
    if (const auto told = qEnvironmentVariable("LUXDECK_PROJECTS"); !told.isEmpty()) return told;
    const QDir program(QCoreApplication::applicationDirPath());
    for (const char* place : {"../share/luxdeck/projects", "../../../projects"}) {
        const QDir folder(program.filePath(QString::fromLatin1(place)));
        if (folder.exists(QStringLiteral("office/project.toml"))) return folder.canonicalPath();
    }
    return {};
}

}  // namespace

std::vector<SampleProject> sampleProjects() {
    std::vector<SampleProject> samples;
    const auto folder = folderOfSamples();
    if (folder.isEmpty()) return samples;
    for (const auto& known : kKnown) {
        const QDir place(folder + QLatin1Char('/') + QString::fromLatin1(known.folder));
        if (!place.exists(QStringLiteral("project.toml"))) continue;
        const auto picture = place.exists(QStringLiteral("picture.jpg")) ? place.filePath(QStringLiteral("picture.jpg")) : QString();
        samples.push_back({QCoreApplication::translate("Samples", known.name), QCoreApplication::translate("Samples", known.description),
                           place.filePath(QStringLiteral("project.toml")), picture});
    }
    return samples;
}

}  // namespace luxdeck::gui
