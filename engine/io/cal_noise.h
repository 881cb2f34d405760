#pragma once

namespace luxdeck::cal {

/// Hermite noise about the lattice of whole numbers: at a lattice point the value and the gradient are random
/// numbers of -1..1 that depend on the point alone; between them they are interpolated with continuous first
/// derivatives. Finite coordinates below 10^15 only; NaN for others.
/// component   0, 1, 2: the interpolated gradient (noise3x, y, z); 3: the noise itself
/// returns     -1..1 for the gradient; the noise itself may pass 1 by a little between lattice points
/// source      Perlin, SIGGRAPH 1985; the lattice's random numbers are Radiance's, so that its textures look the same
double noise3(double x, double y, double z, int component);

/// Fractal noise, about -1..1: eight lattice values halved down to a thousandth of a cell, with displacements that
/// halve too. Same limits.
double fractalNoise3(double x, double y, double z);

/// A number of 0..1 that depends on x alone and hardly looks as if it did.
double randomOf(double x);

}  // namespace luxdeck::cal
