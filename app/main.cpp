#include "app/command.h"

int main(int count, char** words) {
    return pendular::app::run_program({words + 1, words + count});
}
