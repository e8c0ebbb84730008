#include "data/quantities/distributions.h"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>

namespace pendular {
namespace {

namespace math = boost::math;

template <class Law>
double tail_of(const Law& law, double value) {
    return math::cdf(math::complement(law, value));
}

}  // namespace

double normal_below(double z) {
    return math::cdf(math::normal(), z);
}

double normal_density(double z) {
    return math::pdf(math::normal(), z);
}

double normal_quantile(double probability) {
    return math::quantile(math::normal(), probability);
}

double students_t_tail(double t, double freedom) {
    return tail_of(math::students_t(freedom), t);
}

double students_t_quantile(double probability, double freedom) {
    return math::quantile(math::students_t(freedom), probability);
}

double chi_squared_tail(double value, double freedom) {
    return tail_of(math::chi_squared(freedom), value);
}

double chi_squared_quantile(double probability, double freedom) {
    return math::quantile(math::chi_squared(freedom), probability);
}

double chi_squared_exceeded_by(double tail, double freedom) {
    return math::quantile(math::complement(math::chi_squared(freedom), tail));
}

double non_central_chi_squared_tail(double value, double freedom, double away) {
    return tail_of(math::non_central_chi_squared(freedom, away), value);
}

double fisher_f_tail(double ratio, double freedom_above, double freedom_below) {
    return tail_of(math::fisher_f(freedom_above, freedom_below), ratio);
}

double fisher_f_quantile(double probability, double freedom_above, double freedom_below) {
    return math::quantile(math::fisher_f(freedom_above, freedom_below), probability);
}

double binomial_at_least(double successes, double trials, double probability) {
    return tail_of(math::binomial(trials, probability), successes - 1);
}

double digamma(double x) {
    return math::digamma(x);
}

double trigamma(double x) {
    return math::trigamma(x);
}

}  // namespace pendular
