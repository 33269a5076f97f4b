// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

/// In-place radix-2 Fourier transform.
inline void fourierTransform(std::vector<std::complex<double>>& a) {
    constexpr double turn = 6.283185307179586;
    const std::size_t n = a.size();
    for (std::size_t i = 1, j = 0; i < n; ++i) {
        std::size_t bit = n >> 1;
        for (; j & bit; bit >>= 1)
            j ^= bit;
        j ^= bit;
        if (i < j)
            std::swap(a[i], a[j]);
    }
    for (std::size_t length = 2; length <= n; length *= 2)
        for (std::size_t i = 0; i < n; i += length)
            for (std::size_t k = 0; k < length / 2; ++k) {
                const auto turned =
                    std::polar(1.0, -turn * static_cast<double>(k) / static_cast<double>(length)) *
                    a[i + k + length / 2];
                a[i + k + length / 2] = a[i + k] - turned;
                a[i + k] += turned;
            }
}

/// Cross spectrum of two series, summed over half-overlapping Hann windows (Welch). The frequency of bin i is
/// i / window times the sampling rate. @param window a power of two.
inline std::vector<std::complex<double>>
crossSpectrum(const std::vector<double>& first, const std::vector<double>& second, std::size_t window) {
    constexpr double turn = 6.283185307179586;
    std::vector<std::complex<double>> cross(window / 2), a(window), b(window);
    for (std::size_t start = 0; start + window <= first.size(); start += window / 2) {
        for (std::size_t i = 0; i < window; ++i) {
            const double weight =
                0.5 - 0.5 * std::cos(turn * static_cast<double>(i) / static_cast<double>(window));
            a[i] = weight * first[start + i];
            b[i] = weight * second[start + i];
        }
        fourierTransform(a);
        fourierTransform(b);
        for (std::size_t i = 0; i < cross.size(); ++i)
            cross[i] += a[i] * std::conj(b[i]);
    }
    return cross;
}

/// Power spectrum of a series, as above.
inline std::vector<double> powerSpectrum(const std::vector<double>& series, std::size_t window) {
    std::vector<double> power;
    for (const std::complex<double>& value : crossSpectrum(series, series, window))
        power.push_back(value.real());
    return power;
}

/// Least-squares slope of log power over log frequency from `low` to `high`. Bands of equal width in log
/// frequency give each octave the same weight. @param perBin frequency step between bins.
inline double spectralSlope(const std::vector<double>& power, double perBin, double low, double high,
                            int bands) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int band = 0; band < bands; ++band) {
        const double from = low * std::pow(high / low, band / static_cast<double>(bands));
        const double to = low * std::pow(high / low, (band + 1) / static_cast<double>(bands));
        double sum = 0, count = 0;
        for (std::size_t i = 1; i < power.size(); ++i)
            if (const double f = perBin * static_cast<double>(i); f >= from && f < to) {
                sum += power[i];
                ++count;
            }
        if (count == 0)
            continue;
        const double x = 0.5 * std::log(from * to), y = std::log(sum / count);
        n += 1;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}
