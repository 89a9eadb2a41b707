(define (problem test-08)
  (:domain blocks)
  (:objects b1 b2 b3 b4 b5 b6 b7 b8 - block)
  (:init
    (hand-empty) (on-table b4) (on-table b2) (on-table b8) (on-table b5)
    (clear b6) (clear b7) (clear b3) (clear b5) (on b1 b4) (on b6 b1)
    (on b7 b2) (on b3 b8))
  (:goal (and
    (on b8 b2) (on b3 b8) (on b7 b6) (on b4 b5))))
