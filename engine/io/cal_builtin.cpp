#include "engine/io/cal_builtin.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace luxdeck::cal {

namespace {

constexpr std::string_view kLibrary = R"cal(
{ What rayinit.cal gives and nativeFunctions() does not. }
PI : 3.14159265358979323846;
DEGREE : PI/180;
FTINY : 1e-7;

{ Truth is a positive number; what decides is given back, so that these nest. }
not(a) : if(a, -1, 1);
and(a,b) : if(a, b, a);
or(a,b) : if(a, a, b);
xor(a,b) : if(a, not(b), b);
inside(low,x,high) : and(x-low, high-x);

{ Vectors are functions of 1, 2, 3. }
D(i) = select(i, Dx, Dy, Dz);
N(i) = select(i, Nx, Ny, Nz);
P(i) = select(i, Px, Py, Pz);
dot(a,b) : a(1)*b(1) + a(2)*b(2) + a(3)*b(3);
cross(i,a,b) : a(mod(i,3)+1)*b(mod(i+1,3)+1) - a(mod(i+1,3)+1)*b(mod(i,3)+1);

noise3d(i,x,y,z) : select(i, noise3x(x,y,z), noise3y(x,y,z), noise3z(x,y,z));
{ Noise of sizes s, 2s, 4s ... to 1, each as strong as it is large; and the gradient of that. }
turbulence(x,y,z,s) : if(s-1.01, 0, s*abs(noise3(x/s,y/s,z/s)) + turbulence(x,y,z,2*s));
turbulencex(x,y,z,s) : if(s-1.01, 0, sgn(noise3(x/s,y/s,z/s))*noise3x(x/s,y/s,z/s) + turbulencex(x,y,z,2*s));
turbulencey(x,y,z,s) : if(s-1.01, 0, sgn(noise3(x/s,y/s,z/s))*noise3y(x/s,y/s,z/s) + turbulencey(x,y,z,2*s));
turbulencez(x,y,z,s) : if(s-1.01, 0, sgn(noise3(x/s,y/s,z/s))*noise3z(x/s,y/s,z/s) + turbulencez(x,y,z,2*s));
turbulencea(x,y,z,s) : turbulencex(x,y,z,s);
turbulenceb(x,y,z,s) : turbulencey(x,y,z,s);
turbulencec(x,y,z,s) : turbulencez(x,y,z,s);

{ The normal deviate that a fraction p of all are below; Abramowitz and Stegun 26.2.23, to 0.00045. }
upperTail(t) : t - (2.515517 + t*(.802853 + t*.010328)) / (1 + t*(1.432788 + t*(.189269 + t*.001308)));
unif2norm(p) : if(.5-p, -upperTail(sqrt(-2*log(p))), upperTail(sqrt(-2*log(1-p))));
nrand(x) : unif2norm(rand(x));

{ Coordinates on a plane: U is horizontal, and U x V = N; on a horizontal plane they are x and y. }
levelness = Nx*Nx + Ny*Ny;
U = if(levelness-FTINY, (Py*Nx - Px*Ny)/levelness, Px);
V = if(levelness-FTINY, Pz - Nz*(Px*Nx + Py*Ny)/levelness, Py);
)cal";

constexpr std::string_view kSource = R"cal(
{ Photometric data over directions. What leaves the source goes against the ray: (-Dx,-Dy,-Dz).
  A1: multiplier. Box: A2 A3 A4 its sides along x y z; cylinder about z: A2 diameter, A3 height; in metres. }
corr(v) = noneg(if(AC-.5, A1*v, v));
{ Intensity to radiance: divided by the area that is seen. Flat ones have theirs in A1. }
flatcorr(v) = corr(v) / Rdot;
boxcorr(v) = noneg(A1*v) / boxarea;
cylcorr(v) = noneg(A1*v) / cylarea;
boxarea = A3*A4*abs(Dx) + A2*A4*abs(Dy) + A2*A3*abs(Dz);
cylarea = A2*A3*Sqrt(1-Dz*Dz) + PI/4*A2*A2*abs(Dz);
{ The same as seen from the point that the ray started from, for a box about the origin. }
lboxcorr(v) = noneg(A1*v) / lboxarea;
lboxarea = ( A3*A4*noneg(abs(Px-Ts*Dx)-A2/2) + A2*A4*noneg(abs(Py-Ts*Dy)-A3/2) + A2*A3*noneg(abs(Pz-Ts*Dz)-A4/2) ) / Ts;

{ Degrees: theta from straight down, phi from +x towards +y; folded for data of a half or a quarter. }
src_theta = Acos(Dz) / DEGREE;
src_phi = mod(Atan2(-Dy,-Dx) / DEGREE, 360);
src_phi2 = tri(src_phi, 180);
src_phi4 = tri(src_phi, 90);
{ Type B, aimed straight down. }
srcB_vert = Atan2(-Dx,Dz) / DEGREE;
srcB_horiz = Atan2(Dy,Dz) / DEGREE;
srcB_vert2 = abs(srcB_vert);
srcB_horiz2 = abs(srcB_horiz);
)cal";

constexpr std::string_view kTilt = R"cal(
{ How a luminaire hangs, in degrees: for the factors of LM-63's TILT tables. }
tilt_ang = Acos(Kz) / DEGREE;
tilt_ang2 = tri(tilt_ang, 90);
tilt_xang = if(Jy*Jy-FTINY, Asin(Jy/sqrt(Jy*Jy+Jz*Jz)) / DEGREE, 0);
tilt_xang2 = tri(tilt_xang, 90);
)cal";

constexpr std::string_view kSkybright = R"cal(
{ CIE skies as gensky writes them. A1: 1 clear, 2 overcast, 3 uniform, 4 intermediate; A2: zenith radiance;
  A3: ground radiance; A4: normalization; A5 A6 A7: towards the sun. }
cosgamma = Dx*A5 + Dy*A6 + Dz*A7;
gamma = Acos(cosgamma);
eta = Acos(Dz);
zt = Acos(A7);
clearsky = A2/A4 * (.91 + 10*exp(-3*gamma) + .45*sq(cosgamma)) * if(Dz-.01, 1-exp(-.32/Dz), 1);
overcastsky = A2 * (1 + 2*Dz)/3;
uniformsky = A2;
intermediatesky = A2/A4 * ((1.35*sin(5.631-3.59*eta) + 3.12)*sin(4.396-2.6*zt) + 6.37 - eta)/2.326
	* exp(-.563*gamma*((2.629-eta)*(1.562-zt) + .812));
{ Sky above, ground below, and a soft horizon. }
wmean(a,x,b,y) = (a*x + b*y)/(a + b);
skybr = wmean((Dz+1.01)^10, select(A1, clearsky, overcastsky, uniformsky, intermediatesky), (Dz+1.01)^-10, A3);
skybright = skybr;
)cal";

constexpr std::string_view kPerezlum = R"cal(
{ Perez' all-weather sky as gendaylit writes it. A1: radiance of unit relative luminance; A2: ground radiance;
  A3 ... A7: a b c d e; A8 A9 A10: towards the sun. }
cosgamma = Dx*A8 + Dy*A9 + Dz*A10;
gamma = Acos(cosgamma);
gradation = 1 + A3*Exp(A4/max(Dz,.01));
indicatrix = 1 + A5*Exp(A6*gamma) + A7*sq(cos(gamma));
wmean(a,x,b,y) = (a*x + b*y)/(a + b);
skybright = wmean((Dz+1.01)^10, A1*gradation*indicatrix, (Dz+1.01)^-10, A2);
skybr = skybright;
)cal";

constexpr std::string_view kPicture = R"cal(
{ Pictures on the xy plane, the lower left corner in the origin, the shorter side 1 long. A1: height over width. }
pic_u = Px;
pic_v = Py;
pic_aspect = if(AC-.5, A1, 1);
pic_width = max(1, 1/pic_aspect);
pic_height = max(1, pic_aspect);
inpic = if(and(inside(0,pic_u,pic_width), inside(0,pic_v,pic_height)), 1, 0);
tile_u = mod(pic_u, pic_width);
tile_v = mod(pic_v, pic_height);
match_u = tri(pic_u, pic_width);
match_v = tri(pic_v, pic_height);
{ As bricks are laid: every second row is half a picture to the side. }
stag_u = mod(if(frac(pic_v/pic_height/2)-.5, pic_u, pic_u+pic_width/2), pic_width);
stag_v = tile_v;
{ From afar the picture's mean: A2 A3 A4, or A2 for grey. }
fadered(r,g,b) = fade(r, A2, T/10);
fadegreen(r,g,b) = fade(g, A3, T/10);
fadeblue(r,g,b) = fade(b, A4, T/10);
fadegrey(r,g,b) = fade(grey(r,g,b), A2, T/10);
{ 1 where the picture is and does not have the key colour A2 A3 A4, to 2 %. }
keysum = A2 + A3 + A4;
nearkey(v,key,s) : keysum*.02 - abs(v*keysum - key*s);
iskey(r,g,s) : if(FTINY-keysum, .001-s, if(.001-s, -1, and(nearkey(r,A2,s), nearkey(g,A3,s))));
infore(r,g,b) = if(inpic-.5, if(iskey(r,g,r+g+b), 0, 1), 0);
)cal";

constexpr std::string_view kTmesh = R"cal(
{ Triangles with a normal at each corner, or a texture. A1: the axis most across, 0 1 2; then three rows, linear in
  the two others: the normal's x y z. }
bu = select(A1+1, Py, Pz, Px);
bv = select(A1+1, Pz, Px, Py);
row(i) = bu*arg(i) + bv*arg(i+1) + arg(i+2);
v1 = row(2);
v2 = row(5);
v3 = row(8);
nf = 1/sqrt(v1*v1 + v2*v2 + v3*v3);
dx = v1*nf - Nx;
dy = v2*nf - Ny;
dz = v3*nf - Nz;
u = v1;
v = v2;
)cal";

constexpr std::string_view kSurf = R"cal(
{ gensurf -s: A1 the axis most across, 0 1 2; the normal's change as four rows, times uv, u, v and 1. }
surf_u = select(A1+1, Py, Pz, Px);
surf_v = select(A1+1, Pz, Px, Py);
change(i) = surf_u*surf_v*arg(i) + surf_u*arg(i+3) + surf_v*arg(i+6) + arg(i+9);
surf_dx = change(2);
surf_dy = change(3);
surf_dz = change(4);
)cal";

constexpr std::string_view kRev = R"cal(
{ genrev -s, about z: the normal's change along the radius and along z, linear: A3 r + A4 and A1 z + A2. }
rev_rad = sqrt(Px*Px + Py*Py);
rev_dr = A3*rev_rad + A4;
rev_dx = rev_dr*Px/rev_rad;
rev_dy = rev_dr*Py/rev_rad;
rev_dz = A1*Pz + A2;
)cal";

constexpr std::string_view kIllum = R"cal(
{ mkillum's distributions: over a sphere, or over the hemisphere with the axes A1-A3, A4-A6, A7-A9. }
turn(a) : if(a, a, a+2*PI);
along(i) = -(Dx*arg(i) + Dy*arg(i+1) + Dz*arg(i+2));
il_alt = Dz;
il_azi = turn(Atan2(Dy,Dx));
il_alth = sq(along(7));
il_azih = turn(Atan2(along(4),along(1)));
)cal";

constexpr std::string_view kWindow = R"cal(
{ Coated glazing over angle, from fits for clear and bronze glass (Optics 5); A10-A12 and A13-A15: reflectance at
  normal incidence, in front and behind. }
rbase = if(Rdot, 10, 13);
Tclear = clip(-.0015 + RdotP*(3.355 + RdotP*(-3.840 + RdotP*(1.460 + RdotP*.0288))));
Tbronze = clip(-.002 + RdotP*(2.813 + RdotP*(-2.341 + RdotP*(-.05725 + RdotP*.599))));
Rclear = clip(.999 + RdotP*(-.563 + RdotP*(2.043 + RdotP*(-2.532 + RdotP*1.054))) - Tclear);
Rbronze = clip(.997 + RdotP*(-1.868 + RdotP*(6.513 + RdotP*(-7.862 + RdotP*3.225))) - Tbronze);
mixed(r,s) = r*(1-s) + s;
tR_clear = CrP*Tclear;
tG_clear = CgP*Tclear;
tB_clear = CbP*Tclear;
tR_bronze = CrP*Tbronze;
tG_bronze = CgP*Tbronze;
tB_bronze = CbP*Tbronze;
rR_clear = mixed(arg(rbase)*CrP, Rclear);
rG_clear = mixed(arg(rbase+1)*CgP, Rclear);
rB_clear = mixed(arg(rbase+2)*CbP, Rclear);
rR_bronze = mixed(arg(rbase)*CrP, Rbronze);
rG_bronze = mixed(arg(rbase+1)*CgP, Rbronze);
rB_bronze = mixed(arg(rbase+2)*CbP, Rbronze);
)cal";

constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kFiles{{
    {"source.cal", kSource},
    {"tilt.cal", kTilt},
    {"skybright.cal", kSkybright},
    {"perezlum.cal", kPerezlum},
    {"picture.cal", kPicture},
    {"tmesh.cal", kTmesh},
    {"surf.cal", kSurf},
    {"rev.cal", kRev},
    {"illum.cal", kIllum},
    {"window.cal", kWindow},
    {"rayinit.cal", "{ Every function file has its definitions. }"},
}};

}  // namespace

const std::shared_ptr<const Module>& standardLibrary() {
    static const std::shared_ptr<const Module> library = [] {
        auto parsed = Module::parse(kLibrary, "rayinit.cal (built in)");
        if (!parsed) std::abort();  // our own text: cal_builtin_test reads it
        return *std::move(parsed);
    }();
    return library;
}

std::string_view builtinFile(std::string_view name) {
    for (const auto& [file, text] : kFiles)
        if (file == name) return text;
    return {};
}

std::span<const std::string_view> builtinFileNames() {
    static const auto names = [] {
        std::array<std::string_view, kFiles.size()> result;
        std::transform(kFiles.begin(), kFiles.end(), result.begin(), [](const auto& file) { return file.first; });
        return result;
    }();
    return names;
}

}  // namespace luxdeck::cal
