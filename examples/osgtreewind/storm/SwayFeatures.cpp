// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/storm/SwayFeatures.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/gtc/constants.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <complex>

namespace osgTreeWind {

namespace {

constexpr double rate = 4.0; // Hz

using Series = Eigen::VectorXd;

/// The modified Bessel function of the first kind of order 0.
double besselI0(double x) {
    double sum = 1.0, term = 1.0;
    for (int k = 1; k <= 30; ++k)
        sum += term *= 0.25 * x * x / (k * k);
    return sum;
}

using Spectrum = std::vector<std::complex<double>>;

/// The discrete Fourier transform of every `stride`th of a power of two of samples (Cooley and Tukey 1965).
Spectrum transformed(const double* samples, std::size_t size, std::size_t stride = 1) {
    if (size == 1)
        return {samples[0]};
    const Spectrum even = transformed(samples, size / 2, 2 * stride),
                   odd = transformed(samples + stride, size / 2, 2 * stride);
    Spectrum result(size);
    for (std::size_t k = 0; k < size / 2; ++k) {
        const double angle = 2.0 * glm::pi<double>() * static_cast<double>(k) / static_cast<double>(size);
        const std::complex<double> turned =
            std::complex<double>(math::cos(angle), -math::sin(angle)) * odd[k];
        result[k] = even[k] + turned;
        result[k + size / 2] = even[k] - turned;
    }
    return result;
}

/// Keeps every `step`th sample after a low-pass filter: a Kaiser window with beta = 5 over ten steps to each
/// side.
Series downsampled(const Series& x, int step) {
    if (step == 1)
        return x;
    const int half = 10 * step;
    Series filter(2 * half + 1);
    for (int i = -half; i <= half; ++i) {
        const double at = glm::pi<double>() * i / step,
                     inside = 1.0 - static_cast<double>(i) * i / (half * half);
        filter[i + half] = (i == 0 ? 1.0 : math::sin(at) / at) * besselI0(5.0 * std::sqrt(inside));
    }
    filter /= filter.sum();
    Series result((x.size() + step - 1) / step);
    for (Eigen::Index n = 0; n < result.size(); ++n) {
        const Eigen::Index middle = n * step, low = std::max<Eigen::Index>(middle - half, 0),
                           high = std::min<Eigen::Index>(middle + half, x.size() - 1);
        result[n] = x.segment(low, high - low + 1).dot(filter.segment(low - middle + half, high - low + 1));
    }
    return result;
}

/// Removes drift by a high-pass Butterworth filter of second order at 600 s, forward and backward.
Series withoutDrift(const Series& x) {
    const double w = math::tan(glm::pi<double>() / 600.0 / rate), a0 = 1.0 + std::sqrt(2.0) * w + w * w;
    const double a1 = 2.0 * (w * w - 1.0) / a0, a2 = (1.0 - std::sqrt(2.0) * w + w * w) / a0;
    constexpr Eigen::Index edge = 9; // mirrored about the ends
    Series y(x.size() + 2 * edge);
    y << (2.0 * x[0] - x.segment(1, edge).reverse().array()).matrix(), x,
        (2.0 * x[x.size() - 1] - x.segment(x.size() - edge - 1, edge).reverse().array()).matrix();
    for (int pass = 0; pass < 2; ++pass) {
        double first = -y[0] / a0, second = y[0] / a0;
        for (double& value : y) {
            const double in = value, out = in / a0 + first;
            first = -2.0 * in / a0 - a1 * out + second;
            second = in / a0 - a2 * out;
            value = out;
        }
        y.reverseInPlace();
    }
    return y.segment(edge, x.size());
}

/// Power spectrum by Welch's method: Hann windows that overlap by half. Their size is a power of two.
struct PowerSpectrum {
    double step; ///< Hz
    Series power;

    PowerSpectrum(const Series& x, Eigen::Index size) : step(rate / static_cast<double>(size)) {
        Series window(size);
        for (Eigen::Index i = 0; i < size; ++i)
            window[i] = 0.5 - 0.5 * math::cos(2.0 * glm::pi<double>() * static_cast<double>(i) /
                                              static_cast<double>(size));
        power = Series::Zero(size / 2 + 1);
        int count = 0;
        for (Eigen::Index at = 0; at + size <= x.size(); at += size / 2, ++count) {
            const Series part = x.segment(at, size);
            const Series shaped = ((part.array() - part.mean()) * window.array()).matrix();
            const Spectrum spectrum = transformed(shaped.data(), static_cast<std::size_t>(size));
            for (Eigen::Index i = 0; i < power.size(); ++i) {
                const std::complex<double>& value = spectrum[static_cast<std::size_t>(i)];
                power[i] += value.real() * value.real() + value.imag() * value.imag();
            }
        }
        power *= 2.0 / (std::max(count, 1) * rate * window.squaredNorm());
    }
    double frequency(Eigen::Index i) const { return step * static_cast<double>(i); }
    /// Power at frequencies from `low` to below `high`.
    double sum(double low, double high) const {
        double sum = 0.0;
        for (Eigen::Index i = 0; i < power.size(); ++i)
            sum += frequency(i) >= low && frequency(i) < high ? power[i] * step : 0.0;
        return sum;
    }
};

double noiseOf(const PowerSpectrum& spectrum) {
    std::vector<double> powers;
    for (Eigen::Index i = 0; i < spectrum.power.size(); ++i)
        if (spectrum.frequency(i) > 1.7 && spectrum.frequency(i) < 1.95)
            powers.push_back(spectrum.power[i]);
    std::sort(powers.begin(), powers.end());
    return 0.5 * (powers[(powers.size() - 1) / 2] + powers[powers.size() / 2]);
}

/// Fits the logarithm of A q^b / ((1 - q^2)^2 + (2 zeta q)^2) + noise, with q = f / f0, to a spectrum.
struct Oscillator {
    std::vector<double> frequencies, logs;
    double noise;

    /// @param p ln A, b, ln f0 and ln zeta.
    Series residuals(const Eigen::Vector4d& p) const {
        Series r(static_cast<Eigen::Index>(logs.size()));
        const double strength = math::exp(p[0]), f0 = math::exp(p[2]), damping = math::exp(p[3]);
        for (std::size_t i = 0; i < logs.size(); ++i) {
            const double q = frequencies[i] / f0, off = 1.0 - q * q, width = 2.0 * damping * q;
            r[static_cast<Eigen::Index>(i)] =
                logs[i] - math::log(strength * math::pow(q, p[1]) / (off * off + width * width) + noise);
        }
        return r;
    }

    /// Least squares by Levenberg and Marquardt, starting at `p`.
    Eigen::Vector4d fitted(Eigen::Vector4d p) const {
        double damping = 1e-3;
        Series r = residuals(p);
        for (int round = 0; round < 500 && damping < 1e12; ++round) {
            Eigen::MatrixXd slopes(r.size(), 4);
            for (int k = 0; k < 4; ++k) {
                const Eigen::Vector4d step = 1e-6 * Eigen::Vector4d::Unit(k);
                slopes.col(k) = (residuals(p + step) - residuals(p - step)) / 2e-6;
            }
            Eigen::Matrix4d normal = slopes.transpose() * slopes;
            const Eigen::Vector4d downhill = -slopes.transpose() * r;
            normal.diagonal() *= 1.0 + damping;
            const Eigen::Vector4d next = p + normal.ldlt().solve(downhill);
            const Series there = residuals(next);
            if (!(there.squaredNorm() < r.squaredNorm())) {
                damping *= 4.0;
                continue;
            }
            const bool done = r.squaredNorm() - there.squaredNorm() < 1e-12 * r.squaredNorm();
            p = next;
            r = there;
            damping *= 0.2;
            if (done)
                break;
        }
        return p;
    }
};

/// Finds the peak of the sway near `frequency` and sets its frequency, damping and signal-to-noise ratio.
void addSway(const PowerSpectrum& spectrum, double frequency, SwayFeatures& found) {
    Eigen::Index peak = 0;
    double highest = -1.0;
    for (Eigen::Index i = 0; i < spectrum.power.size(); ++i) {
        const double f = spectrum.frequency(i), height = spectrum.power[i] * f * f;
        if (f >= std::max(0.04, 0.5 * frequency) && f <= std::min(1.5, 2.0 * frequency) && height > highest) {
            highest = height;
            peak = i;
        }
    }
    const double noise = noiseOf(spectrum), f0 = spectrum.frequency(peak), power = spectrum.power[peak];
    found.signalToNoise = power / noise;
    found.frequency = f0;
    Oscillator oscillator{{}, {}, 0.5 * noise};
    for (Eigen::Index i = 0; i < spectrum.power.size(); ++i) {
        const double f = spectrum.frequency(i);
        if (f > 0.55 * f0 && f < 1.7 * f0 && f < 1.9) {
            oscillator.frequencies.push_back(f);
            oscillator.logs.push_back(math::log(spectrum.power[i]));
        }
    }
    const Eigen::Vector4d p =
        oscillator.fitted({math::log(0.02 * power), -2.0, math::log(f0), math::log(0.08)});
    if (math::exp(p[2]) > 0.6 * f0 && math::exp(p[2]) < 1.6 * f0) {
        found.frequency = math::exp(p[2]);
        found.damping = math::exp(p[3]);
    }
}

/// Percentile with linear interpolation, as in numpy.
double percentile(Series x, double share) {
    std::sort(x.begin(), x.end());
    const double at = share * static_cast<double>(x.size() - 1);
    const auto low = std::min(static_cast<Eigen::Index>(at), x.size() - 2);
    return x[low] + (at - static_cast<double>(low)) * (x[low + 1] - x[low]);
}

} // namespace

std::optional<SwayFeatures> swayFeatures(const std::vector<glm::dvec2>& series, double seriesRate,
                                         double frequency) {
    const int step = static_cast<int>(std::lround(seriesRate / rate));
    if (step < 1 || std::abs(seriesRate - step * rate) > 1e-6 * rate ||
        static_cast<double>(series.size()) < 1200.0 * seriesRate || !(frequency >= 0.02) ||
        !(frequency <= 2.0))
        return {};
    Eigen::MatrixX2d both;
    for (int axis = 0; axis < 2; ++axis) {
        Series x(static_cast<Eigen::Index>(series.size()));
        for (std::size_t i = 0; i < series.size(); ++i)
            x[static_cast<Eigen::Index>(i)] = series[i][axis];
        x.array() -= x.mean();
        x = withoutDrift(downsampled(x, step));
        both.conservativeResize(x.size(), 2);
        both.col(axis) = x.array() - x.mean();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(both.transpose() * both);
    Series x = both * axes.eigenvectors().col(1);
    const double deviation = std::sqrt(x.squaredNorm() / static_cast<double>(x.size()));
    if (!(deviation > 0.0))
        return {};
    x *= (x.array().cube().mean() < 0.0 ? -1.0 : 1.0) / deviation;
    SwayFeatures found;
    found.alongOverAcross = axes.eigenvalues()[1] / std::max(axes.eigenvalues()[0], 1e-300);
    const PowerSpectrum spectrum(x, 512), slow(x, 4096);
    addSway(spectrum, frequency, found);
    const double root = std::sqrt(2.0), low = found.frequency / root, high = found.frequency * root;
    const double sway = spectrum.sum(low, high);
    found.share = sway / (slow.sum(1.0 / 400.0, low) + sway + spectrum.sum(high, rate));
    found.skewness = x.array().cube().mean();
    found.kurtosis = x.array().square().square().mean();
    found.peak = percentile(x, 0.999);
    return found;
}

} // namespace osgTreeWind
