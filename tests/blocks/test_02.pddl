(define (problem test-02)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 - block)
  (:init
    (hand-empty) (on-table b6) (on-table b1) (on-table b2) (clear b3)
    (clear b4) (clear b2) (on b5 b6) (on b3 b5) (on b4 b1))
  (:goal (and
    (on b3 b6) (on b4 b2) (on b5 b4))))
