#include "analysis/report/offscreen.h"

#include "analysis/report/canvas.h"

#include <QEventLoop>
#include <QGuiApplication>
#include <QLoggingCategory>
#include <QThread>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>

namespace luxdeck::report {

namespace {

/// "D:20261122184000" of "2026-11-22T18:40:00Z"; a fixed day when the contents have no date.
std::string pdfDate(const std::string& created) {
    std::string digits;
    std::copy_if(created.begin(), created.end(), std::back_inserter(digits), [](unsigned char c) { return std::isdigit(c); });
    if (digits.size() < 8) digits = "20000101";
    digits.resize(14, '0');
    return "D:" + digits;
}

/// The caches of fonts use timers, which a thread that Qt did not start has only with a dispatcher.
void readyThread() {
    if (QThread::currentThread() != QCoreApplication::instance()->thread()) thread_local const QEventLoop dispatcher;
}

}  // namespace

void ensureApplication() {
    if (QCoreApplication::instance() != nullptr) return readyThread();
    // Its notes on desktop services ("XDG_RUNTIME_DIR not set") would stand between ours; what matters is in the Result.
    QLoggingCategory::setFilterRules("default.warning=false");
    static int count = 3;
    static char name[] = "luxdeck", option[] = "-platform", platform[] = "offscreen";
    static char* arguments[] = {name, option, platform, nullptr};
    new QGuiApplication(count, arguments);  // kept to the end of the process: Qt allows only one, ever
}

Result<QString> requireFont() {
    auto family = reportFontFamily();
    if (family.isEmpty())
        return Error{ErrorCode::OutOfResources, "no font is installed, expected Inter or DejaVu Sans (packages fonts-inter, fonts-dejavu-core)"};
    return family;
}

void fixPdfDate(std::string& pdf, const std::string& created) {
    constexpr std::string_view kKey = "/CreationDate (";
    const auto at = pdf.rfind(kKey);
    if (at == std::string::npos) return;
    const auto begin = at + kKey.size(), end = pdf.find(')', begin);
    auto date = pdfDate(created) + "Z00'00'";
    date.resize(end - begin, ' ');
    pdf.replace(begin, end - begin, date);
}

}  // namespace luxdeck::report
