target_sources(corral PRIVATE number/Rational.cpp)
