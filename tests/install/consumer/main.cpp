#include <engine/io/photometry.h>

#include <cstdio>

// A lamp of 100 cd in every downward direction emits 2 pi sr x 100 cd = 628.3 lm.
int main() {
    const auto photometry = luxdeck::readIes(
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n100 100\n", "even.ies");
    if (!photometry) {
        std::printf("%s\n", photometry.error().text().c_str());
        return 1;
    }
    const double lumens = photometry->table.lumens();
    std::printf("%.1f lm\n", lumens);
    return lumens > 628.0 && lumens < 628.6 ? 0 : 1;
}
