#pragma once

#include <functional>
#include <string>
#include <vector>

namespace luxdeck::gui {

class Stage;

/// A picture, and what is done before it is taken. False: it could not be done.
struct ScreenshotScene {
    std::string name;  ///< of the file, without .jpg
    std::function<bool(Stage&)> act;
};

const std::vector<ScreenshotScene>& screenshotScenes();

/// Plays the scene in a new window (a fresh copy of a sample project) and writes FOLDER/NAME.jpg.
bool makeScreenshot(const ScreenshotScene& scene, const std::string& folder);

}  // namespace luxdeck::gui
